// Every example by the engine of the page and by the native program: the same numbers, texts and verdicts.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { engine, examples, isMotion, native } from './engine.mjs';

const web = await engine();

/** A design that is found by a search over continuous unknowns ends within the tolerance of the search. */
const isSearch = (deck) => /^ *design:/m.test(deck.text);

/** Texts agree when they do without the digits of their numbers. */
const plain = (text) => text.replace(/[-−]?\d+(\.\d+)?([eE][-+]?\d+)?/g, '#');

/** The largest number of each unit: what a difference is a share of. */
function largest(result) {
  const sizes = new Map();
  const take = (unit, x) => Number.isFinite(x) && sizes.set(unit, Math.max(sizes.get(unit) ?? 0, Math.abs(x)));
  for (const v of Object.values(result.values)) take(v.unit, v.value);
  for (const t of Object.values(result.tables)) {
    for (const row of t.rows) row.forEach((x, i) => typeof x === 'number' && take(t.columns[i].unit, x));
  }
  for (const c of result.checks) take(c.unit, c.value);
  return (unit) => sizes.get(unit) ?? 0;
}

/** A search makes checks equal: which of them comes first is a matter of the last digits that it leaves open. */
const isOfEquals = (column) => /^design_\w+\.(part|check|rule|trust|governs)$/.test(column);
const byName = (checks) => [...checks].sort((x, y) => (x.name < y.name ? -1 : 1));

/** How far b is from a: the largest share for each value and column; Infinity where a text or the number of rows differs. */
function distances(a, b, search = false) {
  const size = largest(a);
  const far = new Map();
  const note = (key, share) => share > 0 && far.set(key, Math.max(far.get(key) ?? 0, share));
  const number = (key, unit, x, y) => {
    if (x === y) return;
    if (typeof x !== 'number' || typeof y !== 'number') return note(key, Infinity);
    note(key, Math.abs(x - y) / Math.max(size(unit), Math.abs(x), Math.abs(y)));
  };
  const text = (key, x, y) => plain(String(x)) !== plain(String(y)) && note(key, Infinity);
  for (const key of ['status', 'verdict', 'verdict_class', 'title', 'method', 'verdict_reason']) text(key, a[key], b[key]);
  text('names of values', Object.keys(a.values), Object.keys(b.values));
  for (const [key, v] of Object.entries(a.values)) number(key, v.unit, v.value, b.values[key]?.value);
  text('names of tables', Object.keys(a.tables), Object.keys(b.tables));
  for (const [key, t] of Object.entries(a.tables)) {
    const other = b.tables[key];
    if (other?.rows.length !== t.rows.length) {
      note(`rows of ${key}`, Infinity);
      continue;
    }
    t.rows.forEach((row, r) => row.forEach((x, c) => {
      const column = `${key}.${t.columns[c].name}`;
      if (search && isOfEquals(column)) return;
      if (typeof x === 'string') text(column, x, other.rows[r][c]);
      else number(column, t.columns[c].unit, x, other.rows[r][c]);
    }));
  }
  const [own, others] = [a, b].map((result) => (search ? byName(result.checks) : result.checks));
  text('checks', own.map((c) => [c.name, c.passes]), others.map((c) => [c.name, c.passes]));
  own.forEach((c, i) => {
    number(`check ${c.name}`, c.unit, c.value, others[i]?.value);
    number(`limit ${c.name}`, c.unit, c.limit, others[i]?.limit);
  });
  // two of the same step stand in either order
  text('warnings', a.warnings.map(plain).sort(), b.warnings.map(plain).sort());
  return far;
}

/** Where or when an extreme is reached: one of several equal ones, by the last digit. */
const isPlace = (key) => /\.(t_max|t_min|where|x)$/.test(key);
/** How many machines a search has tried: it turns at the last digit, what it finds does not. */
const isEffort = (key) => key === 'design_trials';

/** Native results of the same deck in a field of gravity that is changed in its last digits: after an impact a motion
    parts from itself by as much, and nobody can ask more of another processor. */
function nudged(deck) {
  const all = [deck.text, ...Object.values(deck.files)].join('\n');
  const own = /^ {2}gravity: ([0-9.]+) m/m.exec(all);
  const path = own ? 'parameters.gravity' : 'machine.gravity';
  const g = Number(own?.[1] ?? 9.80665);
  return [1 + 2e-15, 1 - 2e-15, 1 + 1e-14].map((k) =>
    JSON.parse(native(deck, '--json', '-q', '--set', `${path}=${(g * k).toPrecision(17)} m/s^2`)));
}

for (const deck of examples()) {
  test(`${deck.name} equals native`, (t) => {
    const began = process.cpuUsage();
    const answer = web.solve(deck);
    const cpu = process.cpuUsage(began).user / 1000;
    assert.equal(answer.failure, undefined);
    const theirs = JSON.parse(native(deck, '--json', '-q'));
    const mine = JSON.parse(web.ask('json'));
    assert.equal(mine.taut.deck_hash, theirs.taut.deck_hash);
    const tolerance = isMotion(deck) ? 1e-4 : 1e-9;
    const far = distances(theirs, mine, isSearch(deck));
    let beyond = [...far].filter(([key, share]) => share > tolerance && !isPlace(key) && !isEffort(key));
    if (beyond.length > 0 && (isMotion(deck) || isSearch(deck))) {
      const itself = nudged(deck).map((other) => distances(theirs, other, isSearch(deck)));
      const parts = (key) => Math.max(...itself.map((d) => d.get(key) ?? 0));
      const table = (key) => Math.max(parts(`rows of ${key.split('.')[0]}`), parts(key));
      const counts = (key) => !isPlace(key) && !isEffort(key) && !/^(events|energy)\./.test(key);
      const all = Math.max(0, ...itself.flatMap((d) => [...d].filter(([key, x]) => counts(key) && Number.isFinite(x)).map(([, x]) => x)));
      const events = itself.some((d) => [...d.keys()].some((key) => /^rows of |^(events|dynamic)\./.test(key)));
      t.diagnostic(`${deck.name}: native parts from itself by ${all.toExponential(1)}`);
      beyond = beyond.filter(([key, share]) =>
        share === Infinity ? !(events && /^(rows of (events|energy)|(events|dynamic|energy)\.)/.test(key)) && !(table(key) > 0)
          : share > 4 * Math.max(all, parts(key)));
    }
    const finite = [...far].filter(([key, share]) => Number.isFinite(share) && !isPlace(key) && !isEffort(key) && !key.startsWith('events.'));
    const worst = Math.max(0, ...finite.map(([, share]) => share));
    t.diagnostic(`${deck.name}: ${worst.toExponential(1)}, ${Math.round(cpu)} ms`);
    assert.deepEqual(beyond, [], `${deck.name} ${beyond.map(([key, share]) => `${key} ${share.toExponential(1)}`)}`);
  });
}

test('places are counted as an editor does', () => {
  const deck = examples().find((e) => e.name === 'machines/running_skyline.yaml');
  const text = deck.text.replace('title: Running skyline', 'title: "ß€𝄞"');
  const { handles } = web.solve({ ...deck, text }).places;
  const tower = handles.find((h) => h.path === 'machine.points.tower');
  assert.deepEqual(tower.numbers.map((n) => text.slice(n.from, n.to)), ['0 m', '0 m', '12 m']);
  assert.deepEqual(tower.at, [0, 0, 12]);
});

test('the report is that of the program', () => {
  const deck = examples().find((e) => e.name === 'mast_section.yaml');
  web.solve(deck);
  const place = mkdtempSync(join(tmpdir(), 'taut-'));
  native(deck, '-q', '-o', place);
  const theirs = execFileSync('cat', [join(place, 'report.html')], { encoding: 'utf8', maxBuffer: 2 ** 28 });
  rmSync(place, { recursive: true });
  assert.equal(plain(web.ask('report')), plain(theirs));
});

test('a file name that leaves the folder is no file', () => {
  const answer = web.solve({ name: 'deck.yaml', text: 'taut: 1\ninclude: ../x.yaml\n', files: { '../x.yaml': 'title: x' } });
  assert.equal(answer.page.status, 'bad_deck');
});
