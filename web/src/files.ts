// Files that a reader chooses together: a deck and what it names. A browser tells their names without folders, a deck
// names them by paths: a path is that of the file with its last name.
import type { Deck } from './types';

export interface Chosen {
  name: string;
  text: string;
}

/** The paths by which a text, but for its comments, names a file. */
function pathsTo(file: string, text: string): string[] {
  const plain = text.replace(/^\s*#.*$/gm, '');
  const name = file.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
  const part = `[^\\s"'\\[\\]{},]`;
  const path = new RegExp(`(?:${part}*/)?(?<![^\\s"'\\[\\]{},:/])${name}(?![\\w.])`, 'g');
  return [...plain.matchAll(path)].map((found) => found[0]);
}

/** Without its dots, but for those in front that lead out of the folder. */
function normal(path: string): string[] {
  const steps: string[] = [];
  for (const step of path.split('/')) {
    if (step === '..' && steps.length > 0 && steps.at(-1) !== '..') steps.pop();
    else if (step !== '' && step !== '.') steps.push(step);
  }
  return steps;
}

/** All files that a deck names, itself or by another one, by their paths from its folder. */
function named(main: Chosen, all: Chosen[]): Map<string, Chosen> {
  const found = new Map<string, Chosen>();
  const take = (text: string, folder: string) => {
    for (const file of all) {
      for (const path of file === main ? [] : pathsTo(file.name, text)) {
        const steps = normal(`${folder}/${path}`);
        const key = steps.join('/');
        if (found.has(key)) continue;
        found.set(key, file);
        take(file.text, steps.slice(0, -1).join('/'));
      }
    }
  };
  take(main.text, '');
  return found;
}

/** The deck that no other one names, with the others by the paths that it uses. Null: no file. */
export function together(all: Chosen[]): Deck | null {
  const decks = all.filter((f) => /\.ya?ml$/.test(f.name));
  const free = decks.filter((f) => !decks.some((other) => other !== f && pathsTo(f.name, other.text).length > 0));
  const main = [...free, ...decks].find((f) => !/\.part\.ya?ml$/.test(f.name)) ?? free[0] ?? decks[0] ?? all[0];
  if (!main) return null;
  const found = named(main, all);
  // what nothing names stands beside the deck: one that is typed later may name it
  const used = new Set(found.values());
  for (const f of all) if (f !== main && !used.has(f)) found.set(f.name, f);
  // a path out of the deck's folder needs one around it, whose name nobody knows
  const out = Math.max(0, ...[...found.keys()].map((path) => path.split('/').filter((step) => step === '..').length));
  const here = 'here/'.repeat(out);
  return {
    name: here + main.name,
    text: main.text,
    files: Object.fromEntries([...found].map(([path, f]) => [normal(here + path).join('/'), f.text])),
  };
}
