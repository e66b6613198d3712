// On a telephone there is room for the panels or for the controls, not for both.

import { place } from "./dom";

const TABS = ["panels", "controls"] as const;

export function setUpTabs(): void {
  const tabs = TABS.map((name) => ({ name, tab: place(`tab-${name}`) }));
  const choose = (chosen: string) => {
    document.body.dataset.tab = chosen;
    for (const { name, tab } of tabs) {
      tab.setAttribute("aria-selected", String(name === chosen));
      tab.tabIndex = name === chosen ? 0 : -1;
    }
  };
  for (const { name, tab } of tabs) {
    tab.addEventListener("click", () => choose(name));
    tab.addEventListener("keydown", (event) => {
      if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
      const other = tabs.find((each) => each.name !== name);
      if (!other) return;
      choose(other.name);
      other.tab.focus();
    });
  }
  choose("panels");
}
