// Where the values of the deck stand in the editor. The engine gives their places in one text; they move on with what
// the page itself writes. A text that was changed in another way has none until the engine has seen it: a place would
// be a guess.
import { Annotation, type ChangeDesc } from '@codemirror/state';
import type { Handle, OutlineNode, Places } from './types';

/** A change by the page in place of a value: of the handle with this path, else of the form. */
export const ownWrite = Annotation.define<{ handle?: string }>();

export class TextPlaces {
  /** Null: not known for the text as it stands. */
  outline: OutlineNode[] | null = null;
  handles: Handle[] | null = null;

  /** Of the text as it stands. */
  set(places: Places): void {
    const handles = places.handles ?? [];
    this.outline = places.outline ?? [];
    // parts whose names have dots may share a path, which then names neither
    this.handles = handles.filter((h) => handles.every((other) => other === h || other.path !== h.path));
  }

  forget(): void {
    this.outline = null;
    this.handles = null;
  }

  follow(changes: ChangeDesc, by: { handle?: string } | undefined): void {
    if (!by) return this.forget();
    // a value of the form may be anything, of which the drawing knows nothing yet
    this.handles = by.handle === undefined ? null : this.left(changes, by.handle);
    for (const h of this.handles ?? []) for (const n of h.numbers) [n.from, n.to] = moved(changes, n.from, n.to);
    for (const node of this.outline ?? []) {
      node.value = moved(changes, ...node.value);
      if (node.key) node.key = moved(changes, ...node.key);
    }
  }

  /** A handle that shares a number with the writer, by an anchor of the deck, is not where it was. */
  private left(changes: ChangeDesc, writer: string): Handle[] | null {
    const untouched = (h: Handle) => h.numbers.every((n) => !changes.touchesRange(n.from, n.to));
    return this.handles?.filter((h) => h.path === writer || untouched(h)) ?? null;
  }
}

/** The range of a value: what is written in its place is the value. */
function moved(changes: ChangeDesc, from: number, to: number): [number, number] {
  return [changes.mapPos(from, -1), changes.mapPos(to, 1)];
}
