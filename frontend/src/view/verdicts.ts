// What the review says: the verdict, the claims, and the findings of the audit.

import type { Row, Said } from "../protocol";
import { el } from "../dom";

type Review = Extract<Said, { say: "review" }>;

const ORDER = { FAIL: 0, PASS: 1, note: 2, "n/a": 3 };

export class Verdicts {
  readonly #root = el("div", { class: "verdicts" });

  constructor(place: HTMLElement) {
    place.append(this.#root);
  }

  show(review: Review | null): void {
    this.#root.setAttribute("aria-busy", String(review === null));
    if (review === null) {
      if (!this.#root.firstChild) this.#root.append(el("p", { class: "faint" }, "The run is being reviewed …"));
      else this.#root.dataset["stale"] = "Of the run before";
      return;
    }
    delete this.#root.dataset["stale"];
    const open = new Set(
      [...this.#root.querySelectorAll<HTMLDetailsElement>("details[data-section]")]
        .filter((group) => group.open)
        .map((group) => group.dataset["section"]),
    );
    this.#root.replaceChildren(
      el("h2", {}, "Verdict"),
      el("p", { class: "verdict" }, review.verdict),
      ...(review.claims.length > 0 ? [claims(review.claims)] : []),
      ...(review.findings.length > 0
        ? [el("h3", {}, "Audit"), ...(review.audit ? [el("p", { class: "card-caption" }, review.audit)] : [])]
        : []),
      ...sections(review.findings).map(([section, rows]) => group(section, rows, open.has(section))),
    );
  }
}

function claims(rows: Row[]): HTMLElement {
  const head = ["Claim", "Statement", "Measured", "Verdict"].map((text) => el("th", { scope: "col" }, text));
  return el(
    "table",
    { class: "claims" },
    el("caption", { class: "unseen" }, "Claims of the scenario"),
    el("thead", {}, el("tr", {}, ...head)),
    el(
      "tbody",
      {},
      ...rows.map((row) =>
        el(
          "tr",
          {},
          el("th", { scope: "row" }, row.id),
          el("td", {}, row.statement, ...criterion(row)),
          el("td", { class: "measured" }, row.measured),
          el("td", {}, badge(row.verdict)),
        ),
      ),
    ),
  );
}

/** The findings by section, in the order in which sections come first. */
function sections(rows: Row[]): [string, Row[]][] {
  const groups = new Map<string, Row[]>();
  for (const row of rows) groups.set(row.section, [...(groups.get(row.section) ?? []), row]);
  return [...groups];
}

function group(section: string, rows: Row[], open: boolean): HTMLElement {
  const asked = rows.filter(({ verdict }) => verdict === "PASS" || verdict === "FAIL");
  const holding = asked.filter(({ verdict }) => verdict === "PASS").length;
  const fails = holding < asked.length;
  const count = asked.length === 0 ? "nothing to be judged" : `${holding} of ${asked.length} hold`;
  const sorted = [...rows].sort((a, b) => ORDER[a.verdict] - ORDER[b.verdict]);
  return el(
    "details",
    { class: "findings", open: open || fails, "data-section": section },
    el("summary", {}, el("span", {}, section), el("span", { class: fails ? "count bad" : "count" }, count)),
    el("ul", {}, ...sorted.map(finding)),
  );
}

function finding(row: Row): HTMLElement {
  return el(
    "li",
    { class: row.verdict === "note" || row.verdict === "n/a" ? "subdued" : "" },
    badge(row.verdict),
    el(
      "div",
      {},
      el("span", { class: "finding-statement" }, row.statement),
      " ",
      el("span", { class: "measured" }, row.measured),
      ...criterion(row),
    ),
  );
}

function criterion({ criterion: text }: Row): HTMLElement[] {
  return text ? [el("div", { class: "criterion" }, text)] : [];
}

function badge(verdict: Row["verdict"]): HTMLElement {
  const words = { PASS: "✓ PASS", FAIL: "✗ FAIL", note: "note", "n/a": "n/a" };
  return el("span", { class: `badge ${verdict === "n/a" ? "na" : verdict.toLowerCase()}` }, words[verdict]);
}
