// Light, dark, or as the system has it.

import type { Palette, Schema } from "./protocol";

export const THEMES = ["system", "light", "dark"] as const;
export type Theme = (typeof THEMES)[number];

const KEY = "dampen-theme";
/** The colours that styles know by name. */
const TOKENS: readonly (keyof Palette)[] = [
  "displacement",
  "rotation",
  "uncontrolled",
  "constraint",
  "learned",
  "reference",
  "ink",
  "faint",
  "paper",
];

export class ThemeSwitch {
  private readonly system = matchMedia("(prefers-color-scheme: dark)");
  private colours: Schema["colours"] | null = null;

  constructor(private readonly changed: (dark: boolean) => void) {
    this.system.addEventListener("change", () => this.apply());
    this.apply();
  }

  get dark(): boolean {
    return this.theme === "system" ? this.system.matches : this.theme === "dark";
  }

  get theme(): Theme {
    const kept = stored();
    return THEMES.find((theme) => theme === kept) ?? this.unkept;
  }

  set theme(theme: Theme) {
    this.unkept = theme;
    store(theme);
    this.apply();
  }

  /** The colours of the project's figures, from the code that draws them. */
  use(colours: Schema["colours"]): void {
    this.colours = colours;
    this.apply();
  }

  /** The choice, where the browser keeps nothing. */
  private unkept: Theme = "system";

  private apply(): void {
    const root = document.documentElement;
    root.dataset.theme = this.dark ? "dark" : "light";
    const palette = this.colours?.[this.dark ? "dark" : "light"];
    for (const token of TOKENS) if (palette) root.style.setProperty(`--${token}`, palette[token]);
    this.changed(this.dark);
  }
}

function stored(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

function store(theme: Theme): void {
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    // Without storage the choice lasts as long as the page.
  }
}
