// node bench.mjs [WORDS]: CPU time of each example that is no motion (or whose name contains WORDS), engine of the page
// against native program. Native: best of 8, without the program's start. Page: the first solve, as a reader waits for it,
// and the best in the steady state: the browser compiles hot code anew for tens of solves, on CPU time that
// counts here. Needs ./dev web and ./dev build taut_cli.
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { engine, examples, isMotion, root } from './test/engine.mjs';

const program = join(root, 'build/bin/taut');
const rounds = 8;
const limit = 3;
const patience = 12000; // ms for a deck

/** CPU time of a program in ms, best of the rounds: node does not tell that of a child, python does. The sum of user and
    system is exact where the parts are guessed from ticks. */
function childTime(folder, ...args) {
  const script = `import resource, subprocess, sys
def taken():
    r = resource.getrusage(resource.RUSAGE_CHILDREN)
    return r.ru_utime + r.ru_stime
best = 1e9
for i in range(int(sys.argv[1])):
    before = taken()
    subprocess.run(sys.argv[2:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    best = min(best, taken() - before)
print(1000 * best)`;
  return Number(execFileSync('python3', ['-c', script, String(rounds), ...args], { cwd: folder, encoding: 'utf8' }));
}

const web = await engine();
const start = childTime(root, program, '--version');
console.log(`start of the program: ${start.toFixed(1)} ms`);
console.log('deck'.padEnd(48), 'native ms', 'first ms', ' page ms', ' ratio');
let slow = 0;
for (const deck of examples()) {
  if (process.argv[2] ? !deck.name.includes(process.argv[2]) : isMotion(deck)) continue;
  const place = mkdtempSync(join(tmpdir(), 'taut-'));
  for (const [name, text] of Object.entries({ ...deck.files, [deck.name]: deck.text })) {
    mkdirSync(dirname(join(place, name)), { recursive: true });
    writeFileSync(join(place, name), text);
  }
  const native = Math.max(childTime(place, program, 'run', deck.name, '--json', '-q') - start, 0.1);
  rmSync(place, { recursive: true });
  let best = Infinity;
  let first = 0;
  const began = performance.now();
  for (let i = 0, since = 0; since < rounds || (i < 40 && performance.now() - began < patience); ++i, ++since) {
    const before = process.cpuUsage();
    web.solve(deck);
    const { user, system } = process.cpuUsage(before);
    const took = (user + system) / 1000;
    if (i === 0) first = took;
    if (took < 0.98 * best) since = 0;
    best = Math.min(best, took);
  }
  const ratio = best / native;
  if (ratio > limit) ++slow;
  console.log(deck.name.padEnd(48), native.toFixed(1).padStart(9), first.toFixed(1).padStart(8), best.toFixed(1).padStart(8), ratio.toFixed(1).padStart(6), ratio > limit ? '  slow' : '');
}
console.log(`${slow} beyond ${limit} times native`);
