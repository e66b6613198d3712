// Bundles the page into the Python package: `npm run build`. What it writes is committed, so that users need no Node.
import { build } from "esbuild";
import { cp, mkdir, readFile, rm, writeFile } from "node:fs/promises";

const page = new URL("../src/dampen/lab/page/", import.meta.url).pathname;
const watched = (path) => new URL(path, import.meta.url).pathname;

await rm(page, { recursive: true, force: true });
await mkdir(page, { recursive: true });
await build({
  entryPoints: { lab: watched("src/main.ts") },
  outdir: page,
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
  legalComments: "none",
  charset: "utf8",
});
await cp(watched("src/index.html"), `${page}index.html`);

// The licences of what is bundled travel with it.
const notices = [];
for (const name of ["three", "uplot"]) {
  const about = JSON.parse(await readFile(watched(`node_modules/${name}/package.json`), "utf8"));
  notices.push(`${name} ${about.version}\n\n${(await readFile(watched(`node_modules/${name}/LICENSE`), "utf8")).trim()}\n`);
}
await writeFile(`${page}LICENSES.txt`, notices.join(`\n${"-".repeat(80)}\n\n`));
