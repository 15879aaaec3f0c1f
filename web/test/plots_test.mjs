// The curves of the page, point by point as the engine gives them.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { engine, examples } from './engine.mjs';
import { browser, example, opened, pictures } from './page.mjs';

const finite = (c) => c.x.map((x, i) => [x, c.y[i]]).filter(([x, y]) => x != null && y != null);

/** Keeps the points of every line that a canvas draws from now on. */
const watched = (page) => page.evaluate(() => {
  window.lines = [];
  const points = new WeakMap();
  for (const name of ['moveTo', 'lineTo']) {
    const own = Path2D.prototype[name];
    Path2D.prototype[name] = function (x, y) {
      points.set(this, [...(points.get(this) ?? []), [x, y]]);
      return own.call(this, x, y);
    };
  }
  const stroke = CanvasRenderingContext2D.prototype.stroke;
  CanvasRenderingContext2D.prototype.stroke = function (path) {
    if (path && points.has(path)) window.lines.push(points.get(path));
    return path ? stroke.call(this, path) : stroke.call(this);
  };
});

/** Whether the pixels are the numbers to scale, to a pixel and a half. */
function toScale(numbers, pixels) {
  const [low, high] = [Math.min(...numbers), Math.max(...numbers)];
  const [from, to] = [numbers.indexOf(low), numbers.indexOf(high)];
  const scale = high > low ? (pixels[to] - pixels[from]) / (high - low) : 0;
  return numbers.every((v, i) => Math.abs(pixels[from] + scale * (v - low) - pixels[i]) < 1.5);
}
const drawn = (lines, points) => lines.some((line) => line.length === points.length &&
  [0, 1].every((k) => toScale(points.map((p) => p[k]), line.map((p) => p[k]))));

test('a curve that goes to and fro along x is a line in its own order, and a jump has both its ends', async () => {
  const one = examples().find((e) => e.title === 'Mast of a tractor yarder, closed loop over 200 m, checked by rule');
  const { page: answer } = (await engine()).solve(one);
  const curves = answer.plots.flatMap((p) => p.curves).filter((c) => !c.points && finite(c).length > 1);
  const turns = (c) => finite(c).slice(1, -1)
    .filter(([x], i) => (x - finite(c)[i][0]) * (finite(c)[i + 2][0] - x) < 0).length;
  const jumps = (c) => finite(c).filter(([x, y], i, all) => i > 0 && all[i - 1][0] === x && all[i - 1][1] !== y).length;
  assert.ok(curves.some((c) => turns(c) > 0));
  assert.ok(curves.some((c) => jumps(c) > 0));
  const { page, context, said } = await opened();
  await watched(page);
  await page.click('#choose-plots');
  await example(page, one.title);
  await page.waitForTimeout(300);
  const lines = await page.evaluate(() => window.lines);
  for (const c of curves) assert.ok(drawn(lines, finite(c)), `${c.label}: ${JSON.stringify(finite(c)).slice(0, 200)}`);
  await page.screenshot({ path: join(pictures, 'plots-mast-light-1280.png') });
  assert.deepEqual(said, []);
  await context.close();
});

test('a picture of the page has every colour that its style names, and is drawn as on paper', async () => {
  const one = examples().find((e) => e.name === 'closed_loop.yaml');
  const e = await engine();
  e.solve(one);
  const all = JSON.parse(e.ask('pictures'));
  assert.ok(all.length > 0);
  for (const { svg } of all) {
    for (const [, name] of svg.matchAll(/var\((--[\w-]+)\)/g)) assert.match(svg, new RegExp(`${name}:`), name);
    assert.doesNotMatch(svg, /prefers-color-scheme/);
  }
  const context = await browser.newContext({ colorScheme: 'dark' });
  const page = await context.newPage();
  await page.setContent(all[0].svg);
  const stroke = (css) => page.locator(css).first().evaluate((shape) => getComputedStyle(shape).stroke);
  assert.equal(await stroke('svg .dimension:not(.head)'), 'rgb(91, 101, 112)');
  assert.equal(await stroke('svg path.bar'), 'rgb(28, 33, 39)');
  await context.close();
});
