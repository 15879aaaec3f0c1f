// node page_bench.mjs: how soon the page from disk is ready and answers, how soon a key shows in the picture, and what a
// drag costs the page's own thread (CPU of its pointermove handlers, of Chromium's trace). running_skyline, which the
// page begins with. Needs ./dev web.
import { address, launched, settled } from './test/chromium.mjs';

const rounds = 5;
const median = (all) => [...all].sort((a, b) => a - b)[Math.floor(all.length / 2)];
const tell = (what, all, limit) => console.log(what.padEnd(58), `median ${median(all).toFixed(1)} ms,`,
  `most ${Math.max(...all).toFixed(1)} ms`, limit ? `(wanted: ${limit} ms)` : '');

const browser = await launched();

/** A new page: when its engine was ready, and when its first answer was seen. */
async function opened() {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, offline: true });
  const page = await context.newPage();
  const began = performance.now();
  await page.goto(address);
  await settled(page);
  const answered = performance.now() - began;
  return { context, page, answered, ready: Number(await page.evaluate(() => document.documentElement.dataset.ready)) };
}

const starts = [];
for (let i = 0; i < rounds; ++i) {
  starts.push(await opened());
  await starts.at(-1).context.close();
}
tell('from the call of the page until the engine is ready', starts.map((s) => s.ready), 1000);
tell('until its first answer is seen', starts.map((s) => s.answered));

const { context, page } = await opened();
const shown = [];
for (let i = 0; i < 10; ++i) {
  shown.push(await page.evaluate((mass) => {
    const view = document.querySelector('.cm-content').cmTile?.view ?? document.querySelector('.cm-content').cmView.view;
    const at = view.state.doc.toString().search(/(?<=at: car, mass: )\d+/);
    view.dispatch({ changes: { from: at, to: at + 3, insert: String(mass) } });
    const began = performance.now();
    return new Promise((done) => {
      new MutationObserver((_, self) => {
        self.disconnect();
        requestAnimationFrame(() => done(performance.now() - began));
      }).observe(document.getElementById('took'), { childList: true });
    });
  }, 901 + i));
}
tell('from a key to the new picture, with the pause of 150 ms', shown, 450);

await browser.startTracing(page, { categories: ['devtools.timeline'] });
for (const path of ['machine.points.tower', 'machine.loads[0].mass']) {
  const box = await page.locator(`.handle[data-path="${path}"]`).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 60; ++i) {
    await page.mouse.move(x + 10 * Math.sin(i / 8), y + i / 3);
    await page.waitForTimeout(16);
  }
  await page.mouse.up();
  await settled(page);
}
const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
const handlers = traceEvents.filter((e) => e.name === 'EventDispatch' && e.args.data?.type === 'pointermove');
tell(`CPU of a pointermove handler in a drag (${handlers.length} of them)`, handlers.map((e) => e.tdur / 1000), 8);
await context.close();
await browser.close();
