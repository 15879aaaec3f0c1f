// The page: deck at the left, machine at the right; the engine answers for every number that is shown.
import { type Diagnostic, setDiagnostics } from '@codemirror/lint';
import { EditorState, Transaction } from '@codemirror/state';
import { EditorView } from '@codemirror/view';
import { byId, el } from './dom';
import { Completer } from './complete';
import { Draft } from './draft';
import { Drawing, type View } from './drawing';
import { deckIn, extensions, openIn, opens, renameIn } from './editor';
import { Engine, Stopped } from './engine';
import { type Change, Form } from './form';
import { together } from './files';
import { FolderFiles } from './folder';
import { take, valuesOf, written } from './handles';
import { TextPlaces, ownWrite } from './places';
import { Player } from './player';
import { Plots } from './plots';
import { RemoteEngine, served } from './remote';
import { underPolicy } from './report';
import { longestLink, packed, unpacked } from './share';
import { Space } from './space';
import type { Answer, Deck, DeckError, Handle, Page, PageEngine, Picture, Scene } from './types';

interface Example extends Deck {
  title: string;
  group: string;
}

const pauseBeforeSolve = 150;
const pauseBeforeWords = 1000;
const gallery: Example[] = JSON.parse(byId('taut-gallery').textContent ?? '[]');
const address = document.documentElement.dataset.address ?? '';
const nonce = document.documentElement.dataset.nonce ?? '';

const remote = served ? new RemoteEngine() : null;
const engine: PageEngine = remote ?? new Engine();
let space: Space | null = null;
let page: Page | null = null;
let scene: Scene | null = null;
let timer = 0;
let firstChange = 0;
/** Changes of the deck so far; the one that the page shown is of (-1: none yet), and the one of the report. */
let version = 0;
let shown = -1;
let reportOf = -1;
/** The engine has the answer, or the mistake, of the deck as it stands: what else it knows of it can be asked. */
let answered = false;

const completer = new Completer(() => engine.ask('schema'));

const editor = new EditorView({
  parent: byId('editor'),
  state: EditorState.create({
    extensions: [
      extensions(nonce, (context) => completer.complete(context)),
      EditorView.updateListener.of((u) => {
        if (u.docChanged) changed(u.transactions);
        if (u.docChanged || u.selectionSet) window.setTimeout(showForm);
      }),
    ],
  }),
});
const deck = () => deckIn(editor);
const draft = new Draft(deck);

const folder = served ? new FolderFiles({ open, deck, announce, saved: savedAs }) : null;

const places = new TextPlaces();
const form = new Form(byId('form'), (path) => completer.words(path), (path) => completer.keys(path), {
  text: () => editor.state.doc.toString(),
  outline: () => places.outline,
  replace: (changes) => editor.dispatch({ changes, annotations: ownWrite.of({}), scrollIntoView: true }),
  add: (changes: Change) => {
    const [anchor, head] = changes.select ?? [changes.from];
    editor.dispatch({ changes, selection: { anchor, head }, scrollIntoView: true });
    editor.focus();
  },
  refuse: announce,
});
function showForm(): void {
  form.show(editor.state.selection.main.head);
}

/** Handles and form follow the text as far as the page itself has written it. */
function changed(transactions: readonly Transaction[]): void {
  for (const t of transactions) if (t.docChanged) places.follow(t.changes, t.annotation(ownWrite));
  drawing.keep(places.handles);
  const other = transactions.some(opens);
  if (other) clear();
  // a deck of elsewhere that comes back may have the name of the file opened last
  if (other && transactions.some((t) => t.isUserEvent('undo') || t.isUserEvent('redo'))) folder?.forget();
  later();
  if (other) void showReport();
}

const drawing = new Drawing(byId('picture'), move, choose);
const plots = new Plots(byId('plots'), (of, t) => player.point(of, t));
const player = new Player((chosen) => showScene(chosen, true), (frame, of, t, tell) => {
  drawing.setFrame(frame);
  if (!byId('space').hidden) space?.setFrame(frame);
  if (tell && of) plots.setTime(of.name, t);
});

/** What is shown is of a text before the one in the editor: verdict, picture and numbers are greyed. */
function setOld(old: boolean): void {
  byId('machine').classList.toggle('old', old);
  window.clearTimeout(waiting);
  if (old) waiting = window.setTimeout(() => say('Calculating', 'pending', 'What is shown is of the deck before the change.'), pauseBeforeWords);
}
let waiting = 0;

function later(): void {
  ++version;
  answered = false;
  announce('');
  setOld(true);
  window.clearTimeout(timer);
  // a drag that does not pause is followed all the same
  const now = performance.now();
  if (firstChange === 0) firstChange = now;
  timer = window.setTimeout(() => {
    firstChange = 0;
    void solve();
  }, Math.max(0, Math.min(pauseBeforeSolve, firstChange + 3 * pauseBeforeSolve - now)));
}

async function solve(): Promise<void> {
  const mine = version;
  try {
    const answer = await engine.solve(deck());
    if (answer && mine === version) show(answer);
  } catch (error) {
    if (!(error instanceof Stopped)) say(`The engine has failed: ${(error as Error).message}`, 'fails');
  }
}

/** The picture moves with the pointer; the text follows several times a second, and the solve follows the text. */
function move({ path }: Handle, values: number[], done: boolean): void {
  window.clearTimeout(writing);
  if (!done) {
    // the editor takes longer than a pointer may be kept waiting
    const pause = Math.max(0, lastMoved + pauseBeforeSolve - performance.now());
    writing = window.setTimeout(() => write(path, values), pause);
    return;
  }
  write(path, values);
}
let writing = 0;

/** Nothing is written for a handle of a text that was changed otherwise meanwhile: its place is not known. */
function write(path: string, values: number[]): void {
  lastMoved = performance.now();
  const handle = places.handles?.find((h) => h.path === path);
  if (!handle) return announce('The deck has changed meanwhile: the number is not written.');
  const text = editor.state.doc.toString();
  const before = valuesOf(handle);
  const changes = handle.numbers
    .map((n, i) => ({ from: n.from, to: n.to, insert: written(values[i]!, n) }))
    .filter((c, i) => values[i] !== before[i] && text.slice(c.from, c.to) !== c.insert);
  if (changes.length === 0) return;
  editor.dispatch({ changes, annotations: [Transaction.userEvent.of('move.handle'), ownWrite.of({ handle: path })] });
  take(handle, values);
}
let lastMoved = 0;

function choose(handle: Handle): void {
  const first = handle.numbers[0];
  if (first && first.to <= editor.state.doc.length) {
    editor.dispatch({ effects: EditorView.scrollIntoView(first.from, { y: 'center' }) });
  }
}

function say(words: string, kind: string, reason = ''): void {
  window.clearTimeout(waiting);
  const verdict = byId('verdict');
  verdict.dataset.kind = kind;
  verdict.replaceChildren(el('b', {}, words), ...(reason ? [el('span', {}, reason)] : []));
}

/** The answer of the deck as it stands. */
function show(answer: Answer): void {
  if (!answer.page) {
    say(`taut has failed: ${answer.failure ?? ''}`, 'fails', 'Please report it with this deck.');
    return;
  }
  answered = true;
  mark(answer.page);
  if (answer.page.status === 'bad_deck') {
    say(answer.page.message, 'bad', answer.page.errors[0]?.message ?? '');
    list('notes', answer.page.errors.map(mistake));
    if (!page) void showReport();
    return;
  }
  const first = page === null;
  page = answer.page;
  shown = version;
  places.set(answer.places ?? {});
  showForm();
  setOld(false);
  say(page.verdict?.words ?? page.status, page.verdict?.kind ?? 'no_answer', page.verdict?.reason ?? page.message);
  byId('took').textContent = `solved in ${Math.round(answer.took)} ms`;
  document.title = `${page.title || deck().name} - taut`;
  scene = player.take(page.scenes);
  byId('drawn').hidden = scene === null && !places.handles?.length;
  byId('pictures').hidden = !byId('drawn').hidden;
  if (!byId('drawn').hidden) list('figures', []);
  void showPictures();
  showScene(scene, !first);
  drawing.place(places.handles ?? []);
  showChecks();
  showValues();
  list('notes', [
    ...(page.interrupted ? [el('p', { class: 'unsafe' }, page.message)] : []),
    ...(page.headline ? [el('p', {}, page.headline)] : []),
    ...page.answers.map((a) => el('p', {}, el('b', {}, `${a.label}: `), a.text)),
    ...page.warnings.map((w) => el('p', { class: w.unsafe ? 'unsafe' : 'warning' }, w.text)),
  ]);
  plots.show(page.plots);
  void showReport();
}

function list(id: string, children: Node[]): void {
  byId(id).replaceChildren(...children);
}

/** Whether its place is in the editor: included decks are not. */
function isHere(e: DeckError): boolean {
  return e.file === deck().name && e.line > 0;
}

function mistake(e: DeckError): HTMLElement {
  const words = `${e.file}:${e.line}:${e.column} ${e.message}`;
  if (!isHere(e)) return el('p', { class: 'error' }, words);
  const go = () => {
    editor.dispatch({ selection: { anchor: place(e.line, e.column) }, scrollIntoView: true });
    editor.focus();
  };
  return el('button', { type: 'button', class: 'error', onclick: go }, words);
}

function place(line: number, column: number): number {
  const doc = editor.state.doc;
  const at = doc.line(Math.min(Math.max(line, 1), doc.lines));
  return Math.min(at.from + Math.max(column - 1, 0), at.to);
}

function mark(p: Page): void {
  const marks: Diagnostic[] = p.errors
    .filter(isHere)
    .map((e) => {
      const from = place(e.line, e.column);
      return { from, to: Math.min(from + Math.max(e.width, 1), editor.state.doc.lineAt(from).to), severity: 'error', message: e.message };
    });
  editor.dispatch(setDiagnostics(editor.state, marks));
}

/** From the side, from above, or in space. */
function setView(view: string): void {
  const inSpace = view === 'space';
  if (inSpace && !space) {
    try {
      space = new Space(byId('space'));
    } catch {
      byId<HTMLSelectElement>('view').value = 'side';
      return announce('This browser has no WebGL: the machine cannot be shown in space.');
    }
  }
  byId('space').hidden = !inSpace;
  byId('picture').hidden = inSpace;
  if (inSpace) space?.show(scene, false);
  else drawing.setView(view as View);
}

/** `keep`: space is looked at as before. */
function showScene(of: Scene | null, keep: boolean): void {
  scene = of;
  drawing.show(page, scene);
  if (!byId('space').hidden) space?.show(scene, keep);
  showScale();
  player.rewind();
}

function showScale(): void {
  const range = scene?.tension ?? null;
  byId('scale').hidden = range === null;
  byId('scale-low').textContent = range?.least_text ?? '';
  byId('scale-high').textContent = range?.most_text ?? '';
}

let imageUrls: string[] = [];
let picturesOf = -1;
/** As images: nothing in them can run or load. They cost time, so they are made when somebody looks. */
async function showPictures(): Promise<void> {
  const inTab = !byId('drawn').hidden;
  // of a deck that has changed meanwhile the engine has none
  if (picturesOf === shown || shown !== version || !answered || (inTab && byId('tab-plots').hidden)) return;
  const mine = shown;
  const all: Picture[] = page?.pictures ? JSON.parse(await asked('pictures') || '[]') : [];
  if (mine !== version) return;
  picturesOf = mine;
  const before = imageUrls;
  imageUrls = [];
  const figures = all.map((p) => {
    const url = URL.createObjectURL(new Blob([p.svg], { type: 'image/svg+xml' }));
    imageUrls.push(url);
    return el('figure', {}, el('figcaption', {}, el('b', {}, p.title)), el('img', { src: url, alt: `${p.title}. ${p.caption}` }),
      el('p', { class: 'caption' }, `${p.caption} ${p.scale}`));
  });
  list('pictures', inTab ? [] : figures);
  list('figures', inTab ? figures : []);
  for (const url of before) URL.revokeObjectURL(url);
}

function showChecks(): void {
  const rows = (page?.checks ?? []).map((c) => {
    const bar = el('span', { class: 'bar' });
    bar.style.setProperty('--share', String(Math.min(c.utilisation ?? 0, 1)));
    return el('tr', { class: c.outcome },
      el('td', {}, c.name),
      el('td', {}, c.value), el('td', {}, `${c.sense} ${c.limit}`),
      el('td', {}, bar, ` ${c.share}`), el('td', {}, c.outcome),
      el('td', { class: 'rule' }, c.rule, c.where ? ` (${c.where})` : '', c.trust.startsWith('UNVERIFIED') ? ' - unverified' : ''));
  });
  list('checks', rows.length === 0 ? [el('p', { class: 'empty' }, 'Nothing is checked: the deck asks for no limit.')]
    : [table(['check', 'value', 'limit', 'used', '', 'rule'], rows)]);
}

function showValues(): void {
  const rows = (page?.values ?? []).filter((v) => !v.detail)
    .map((v) => el('tr', {}, el('td', {}, v.label), el('td', { class: 'number' }, v.text), el('td', { class: 'rule' }, v.name)));
  list('values', [table(['value', '', 'name'], rows)]);
}

function table(heads: string[], rows: HTMLElement[]): HTMLElement {
  return el('table', {}, el('thead', {}, el('tr', {}, ...heads.map((h) => el('th', { scope: 'col' }, h)))), el('tbody', {}, ...rows));
}

// The report: in a frame in which nothing runs and which is of no origin.
async function showReport(): Promise<void> {
  if (byId('tab-report').hidden) return;
  // the report of what else is shown stays, greyed as that is
  if (reportOf === version || (!answered && reportOf >= 0 && reportOf === shown)) return;
  reportOf = -1;
  const none = el('p', { class: 'empty' }, 'The report comes with the answer of this deck.');
  if (!answered) return list('tab-report', [none]);
  const mine = version;
  const html = await asked('report');
  if (mine !== version || !html) return;
  reportOf = mine;
  const frame = el('iframe', { sandbox: '', title: 'report', srcdoc: underPolicy(nonce, html) });
  const saved = () => void withReport((of) => save('report.html', of, 'text/html'));
  list('tab-report', [
    el('p', { class: 'tools' },
      el('button', { type: 'button', onclick: saved }, 'Save report'),
      el('button', { type: 'button', onclick: () => void withReport(print) }, 'Print')),
    frame,
  ]);
}
/** Of the deck as it stands, or none: what is shown may be of the deck before. */
async function withReport(use: (html: string) => void): Promise<void> {
  const html = answered ? await asked('report') : '';
  if (html) use(html);
  else announce('There is no report: the deck as it stands has no answer yet.');
}
/** Empty where the engine was stopped meanwhile, or cannot be reached. */
async function asked(what: string): Promise<string> {
  try {
    return await engine.ask(what);
  } catch {
    return '';
  }
}
function print(html: string): void {
  const url = URL.createObjectURL(new Blob([underPolicy(nonce, html)], { type: 'text/html' }));
  const other = window.open(url);
  if (!other) return announce('The browser has blocked the window: save the report and print it.');
  other.addEventListener('load', () => other.print());
}

function save(file: string, text: string, type: string): void {
  const url = URL.createObjectURL(new Blob([text], { type }));
  const link = el('a', { href: url, download: file });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

function announce(words: string): void {
  byId('said').textContent = words;
}

function open(d: Deck): void {
  openIn(editor, d);
  draft.isSaved();
}

/** Nothing of the deck before is shown beside another one. */
function clear(): void {
  page = null;
  window.clearTimeout(writing);
  drawing.place([]);
  showScene(player.take([]), true);
  byId('took').textContent = '';
  for (const id of ['notes', 'checks', 'values', 'tab-report', 'pictures', 'figures']) list(id, []);
  plots.show([], 'The plots come with the answer of this deck.');
  shown = -1;
  reportOf = -1;
  const { name } = deck();
  byId('deck-name').textContent = name;
  document.title = `${name} - taut`;
}

/** The deck stands in a file of the folder. */
function savedAs(name: string): void {
  renameIn(editor, name);
  byId('deck-name').textContent = name;
  draft.isSaved();
}

async function share(): Promise<void> {
  // an address of taut serve holds its token
  const own = location.protocol !== 'file:' && !served;
  const base = own ? location.href.replace(/#.*$/, '') : address;
  const hash = `#deck=${await packed(deck())}`;
  if (!base) return announce('This page has no web address to link to: save the deck and send it.');
  if (base.length + hash.length > longestLink) return announce('This deck is too long for a link: save it and send the file.');
  if (own) window.history.replaceState(null, '', hash);
  draft.isSaved();
  if (await copied(base + hash)) return announce('The link is in the clipboard.');
  announce(own ? 'The link is in the address bar.' : `The browser gives no clipboard. The link: ${base + hash}`);
}

/** A page that came without encryption has no clipboard at all. */
async function copied(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}

async function openFiles(input: HTMLInputElement): Promise<void> {
  const chosen = [...(input.files ?? [])];
  // the same file can be chosen again
  input.value = '';
  const found = together(await Promise.all(chosen.map(async (f) => ({ name: f.name, text: await f.text() }))));
  if (found) open(found);
}

function tabs(): void {
  const all = [...document.querySelectorAll<HTMLButtonElement>('[role=tab]')];
  const choose = (tab: HTMLButtonElement) => {
    for (const one of all) {
      const on = one === tab;
      one.setAttribute('aria-selected', String(on));
      one.tabIndex = on ? 0 : -1;
      byId(one.getAttribute('aria-controls')!).hidden = !on;
    }
    plots.resize();
    if (tab.id === 'choose-report') void showReport();
    if (tab.id === 'choose-plots' && page) void showPictures();
  };
  all.forEach((tab, i) => {
    tab.addEventListener('click', () => choose(tab));
    tab.addEventListener('keydown', (event) => {
      const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
      if (step === 0) return;
      const other = all[(i + step + all.length) % all.length]!;
      choose(other);
      other.focus();
    });
  });
}

function setTheme(dark: boolean): void {
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';
  byId('theme').setAttribute('aria-pressed', String(dark));
}
function theme(): void {
  setTheme(document.documentElement.dataset.theme !== 'dark');
  drawing.draw();
  if (!byId('space').hidden) space?.show(scene, true);
  if (page) plots.show(page.plots);
}

async function begin(): Promise<void> {
  setTheme(matchMedia('(prefers-color-scheme: dark)').matches);
  const select = byId<HTMLSelectElement>('examples');
  for (const group of new Set(gallery.map((e) => e.group))) {
    const part = el('optgroup', { label: group });
    gallery.forEach((e, i) => e.group === group && part.append(el('option', { value: i }, e.title)));
    select.append(part);
  }
  select.addEventListener('change', () => {
    const chosen = gallery[Number(select.value)];
    if (chosen) open(chosen);
  });
  tabs();
  byId('open').addEventListener('click', () => byId('file').click());
  byId('file').addEventListener('change', (event) => void openFiles(event.target as HTMLInputElement));
  byId('save').addEventListener('click', () => {
    if (folder) return void folder.save();
    save(deck().name.split('/').at(-1) ?? '', deck().text, 'text/yaml');
    draft.isSaved();
  });
  byId('share').addEventListener('click', () => void share());
  byId('theme').addEventListener('click', theme);
  byId('view').addEventListener('change', () => setView(byId<HTMLSelectElement>('view').value));
  byId('stop').addEventListener('click', () => { void engine.stop().then((comes) => comes || say('Stopped', 'no_answer')); });
  engine.onProgress = (p) => {
    byId('working').hidden = p === null;
    if (p) {
      byId<HTMLProgressElement>('done').value = p.done;
      byId('words').textContent = `${p.what}: ${p.words}`;
    }
  };
  // what a reader wants on paper is the report
  window.addEventListener('keydown', (event) => {
    if (event.key.toLowerCase() !== 'p' || !(event.ctrlKey || event.metaKey) || event.shiftKey) return;
    event.preventDefault();
    void withReport(print);
  });
  window.addEventListener('hashchange', async () => {
    const linked = await unpacked(location.hash);
    if (linked) open(linked);
  });
  const started = engine.start();
  const linked = await unpacked(location.hash);
  const earlier = await remote?.earlier();
  const first = linked ?? earlier ?? gallery.find((e) => e.name.endsWith('running_skyline.yaml')) ?? gallery[0];
  const kept = draft.before();
  if (kept) openIn(editor, kept);
  else if (first) open(first);
  try {
    await started;
    document.documentElement.dataset.ready = String(Math.round(performance.now()));
  } catch (error) {
    say(`The engine cannot start: ${(error as Error).message}`, 'fails');
  }
}

void begin();
