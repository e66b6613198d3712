// Starts the page.

import "./style.css";
import { place } from "./dom";
import { setUpDrop } from "./drop";
import { Lab } from "./lab";
import { fetchSchema, fetchStart } from "./server";
import { setUpTabs } from "./tabs";
import { ThemeSwitch } from "./theme";

async function start(): Promise<void> {
  let lab: Lab | null = null;
  const theme = new ThemeSwitch((dark) => lab?.colours(dark));
  setUpTabs();
  const [schema, opened] = await Promise.all([fetchSchema(), fetchStart()]);
  theme.use(schema.colours);
  const made = new Lab(schema, opened, theme);
  lab = made;
  made.colours(theme.dark);
  setUpDrop((file) => void made.open(file));
  addEventListener("hashchange", () => void made.navigate());
  addEventListener("keydown", (event) => {
    const finding = event.target instanceof HTMLInputElement && event.target.type === "search";
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z" || finding) return;
    event.preventDefault();
    if (event.shiftKey) made.redo();
    else made.undo();
  });
  await made.begin();
}

start().catch((error: unknown) => {
  place("status").textContent = "The page could not start.";
  throw error;
});
