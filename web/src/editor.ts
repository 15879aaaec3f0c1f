// The editor of the deck: its text, and beside it the deck's name and files, which undo brings back with the text.
import { type CompletionSource, autocompletion, completionKeymap } from '@codemirror/autocomplete';
import {
  defaultKeymap, history, historyKeymap, indentWithTab, invertedEffects, isolateHistory,
} from '@codemirror/commands';
import { yaml } from '@codemirror/lang-yaml';
import { HighlightStyle, bracketMatching, syntaxHighlighting } from '@codemirror/language';
import { lintGutter, lintKeymap } from '@codemirror/lint';
import { highlightSelectionMatches, searchKeymap } from '@codemirror/search';
import { type Extension, StateEffect, StateField, Transaction } from '@codemirror/state';
import { EditorView, drawSelection, highlightActiveLine, keymap, lineNumbers } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import { byId } from './dom';
import type { Deck } from './types';

type Around = Pick<Deck, 'name' | 'files'>;

const setAround = StateEffect.define<Around>();
const around = StateField.define<Around>({
  create: () => ({ name: '', files: {} }),
  update: (value, t) => t.effects.reduce((v, e) => (e.is(setAround) ? e.value : v), value),
});

const colours = HighlightStyle.define([
  { tag: tags.comment, class: 'tok-comment' },
  { tag: [tags.propertyName, tags.definition(tags.propertyName)], class: 'tok-key' },
  { tag: tags.string, class: 'tok-string' },
]);

export function extensions(nonce: string, complete: CompletionSource): Extension {
  return [
    EditorView.cspNonce.of(nonce),
    around,
    invertedEffects.of((t) => t.effects.some((e) => e.is(setAround)) ? [setAround.of(t.startState.field(around))] : []),
    lineNumbers(),
    history(),
    drawSelection(),
    highlightActiveLine(),
    highlightSelectionMatches(),
    bracketMatching(),
    yaml(),
    syntaxHighlighting(colours),
    autocompletion({ override: [complete] }),
    lintGutter(),
    EditorView.contentAttributes.of({ 'aria-label': 'deck' }),
    keymap.of([...completionKeymap, { key: 'Escape', run: leave }, indentWithTab, ...defaultKeymap, ...historyKeymap,
      ...searchKeymap, ...lintKeymap]),
  ];
}

/** Tab indents in the editor; after Escape the next Tab goes on to the machine. */
function leave(view: EditorView): boolean {
  view.contentDOM.blur();
  byId('machine').focus();
  return true;
}

export function deckIn(view: EditorView): Deck {
  return { ...view.state.field(around), text: view.state.doc.toString() };
}

/** Another deck takes the place of the one in the editor; undo takes it back, all but the first. */
export function openIn(view: EditorView, deck: Deck): void {
  const first = view.state.field(around).name === '';
  view.dispatch({
    changes: { from: 0, to: view.state.doc.length, insert: deck.text },
    selection: { anchor: 0 },
    effects: setAround.of({ name: deck.name || 'deck.yaml', files: { ...deck.files } }),
    annotations: [isolateHistory.of('full'), Transaction.addToHistory.of(!first)],
    scrollIntoView: true,
  });
}

export function renameIn(view: EditorView, name: string): void {
  const { files } = view.state.field(around);
  view.dispatch({ effects: setAround.of({ name, files }), annotations: Transaction.addToHistory.of(false) });
}

/** Whether it brings another deck, by itself or by undo. */
export function opens(t: Transaction): boolean {
  return t.docChanged && t.effects.some((e) => e.is(setAround));
}
