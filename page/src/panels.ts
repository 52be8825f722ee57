/** Which columns of a series are drawn together. */

/** Columns that differ only in the number of their barrier are one panel. */
export interface Panel {
  title: string;
  columns: string[];
}

/** Columns of all runs: one may have more barriers than another. */
export function allColumns(runs: string[][]): string[] {
  return [...new Set(runs.flat())];
}

/** Panels of all columns but the time, in the order of the columns. */
export function panels(columns: string[]): Panel[] {
  const found = new Map<string, Panel>();
  for (const name of columns.slice(1)) {
    const title = name.replace(/^barrier_\d+_/, '');
    const panel = found.get(title) ?? { title, columns: [] };
    panel.columns.push(name);
    found.set(title, panel);
  }
  return [...found.values()];
}

/** What is shown first: retention, load, energy and discharge where there are such columns, else the first. */
export function firstPanels(all: Panel[]): string[] {
  const wanted = ['retention', 'force_x', 'kinetic_energy', 'discharge', 'depth', ''];
  const chosen: string[] = [];
  for (const word of wanted) {
    const panel = all.find((one) => one.title.includes(word) && !chosen.includes(one.title));
    if (panel && chosen.length < 4) chosen.push(panel.title);
  }
  return chosen;
}
