// What is asked of the server besides runs: the schema, scenarios, files in both directions.

import type { Fault, Opened, Schema, Table } from "./protocol";

export type Download = "toml" | "netcdf" | "figures" | "report";

/** The server would not do it, and says what is wrong. */
export class Refused extends Error {
  constructor(readonly faults: Fault[]) {
    super(faults.map(({ at, text }) => (at ? `${at} ${text}` : text)).join(" "));
  }
}

const HEADER = { "X-Dampen": "lab" };

export const fetchSchema = (): Promise<Schema> => get("/schema");
export const fetchStart = (): Promise<Opened> => get("/start");
export const fetchScenario = (name: string): Promise<Opened> => get(`/scenario/${encodeURIComponent(name)}`);

/** A scenario or a stored result from the user's disk. */
export async function readFile(file: File): Promise<Opened> {
  return (await (await post(`/read?name=${encodeURIComponent(file.name)}`, file)).json()) as Opened;
}

/** Gives the server a file that a scenario names; returns the name to put into the scenario. */
export async function attachFile(file: File): Promise<string> {
  const answer = await post(`/attach?name=${encodeURIComponent(file.name)}`, file);
  return ((await answer.json()) as { attachment: string }).attachment;
}

/** Has the server make a file of this scenario, and hands it to the browser to save; of a stored result, the file itself. */
export async function download(what: Download, table: Table, token?: string): Promise<void> {
  const answer = await post(`/download/${what}`, JSON.stringify({ table, token }));
  const name = /filename="?([^";]+)"?/.exec(answer.headers.get("Content-Disposition") ?? "")?.[1] ?? `dampen-${what}`;
  const address = URL.createObjectURL(await answer.blob());
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

async function get<Answer>(path: string): Promise<Answer> {
  const answer = await fetch(path);
  if (!answer.ok) throw new Error(`The server has no ${path}.`);
  return (await answer.json()) as Answer;
}

async function post(path: string, body: string | File): Promise<Response> {
  const type = typeof body === "string" ? "application/json" : "application/octet-stream";
  const answer = await fetch(path, { method: "POST", headers: { ...HEADER, "Content-Type": type }, body });
  if (answer.ok) return answer;
  const said = (await answer.json().catch(() => null)) as { faults?: Fault[] } | null;
  throw new Refused(said?.faults ?? [{ at: "", text: `The server could not do this (${answer.status}).` }]);
}
