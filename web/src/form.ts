// The part under the cursor as a form: one field for each value that the deck gives, with the words of its description.
import { el } from './dom';
import type { OutlineNode, Places } from './types';

export interface Change {
  from: number;
  to: number;
  insert: string;
}

/** "machine.sheaves.a.at[0]" as steps of a schema. */
export function steps(path: string): string[] {
  return path.split('.').flatMap((part) => part.split(/(?=\[)/).map((p) => (p.startsWith('[') ? '[]' : p)));
}

/** The rest of the line behind a part: brackets and a comment. */
function onlyCloses(rest: string): boolean {
  return /^[ \t}\],]*(#[^\n]*)?$/.test(rest);
}

/** The innermost map around the cursor that has values of its own, and these. */
function partAt(places: Places, at: number, text: string): { part: OutlineNode; values: OutlineNode[] } | null {
  const outline = places.outline ?? [];
  const around = outline
    .filter((n) => n.kind === 'map' && (n.key?.[0] ?? n.value[0]) <= at && (at <= n.value[1] || onlyCloses(text.slice(n.value[1], at))))
    .sort((a, b) => b.path.length - a.path.length);
  for (const part of around) {
    const values = outline.filter((n) => {
      const rest = n.path.startsWith(`${part.path}.`) ? n.path.slice(part.path.length + 1) : '';
      return rest !== '' && !/[.[]/.test(rest) && n.kind === 'scalar';
    });
    if (values.length > 0) return { part, values };
  }
  return null;
}

export class Form {
  private shown = '';

  constructor(
    private box: HTMLElement,
    private words: (path: string[]) => Promise<string>,
    private write: (change: Change) => void,
  ) {}

  /** `places` hold for the text as it stands; null: they do not. */
  show(places: Places | null, at: number, text: string): void {
    const found = places ? partAt(places, at, text) : null;
    this.box.hidden = !found;
    if (!found) {
      this.shown = '';
      return;
    }
    const state = `${found.part.path} ${found.values.map((v) => text.slice(...v.value)).join('|')}`;
    if (state === this.shown || this.box.contains(document.activeElement)) return;
    this.shown = state;
    this.box.replaceChildren(
      el('b', {}, found.part.path),
      ...found.values.map((v) => {
        const name = v.path.slice(found.part.path.length + 1);
        const input = el('input', { value: text.slice(...v.value), spellcheck: 'false' });
        const field = el('label', {}, name, input);
        void this.words(steps(v.path)).then((words) => {
          field.title = words;
        });
        input.addEventListener('change', () => {
          this.shown = '';
          this.write({ from: v.value[0], to: v.value[1], insert: input.value });
        });
        return field;
      }),
    );
  }
}
