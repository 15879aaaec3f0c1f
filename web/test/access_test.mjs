// Keyboard, screen reader and contrast: what the browser itself tells of the page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { example, opened, settled, write, text } from './page.mjs';

const roles = new Set(['button', 'combobox', 'textbox', 'slider', 'tab', 'link', 'checkbox', 'spinbutton', 'listbox', 'progressbar', 'tabpanel',
  'Iframe', 'image', 'group', 'menuitem', 'searchbox']);

/** Nodes of the accessibility tree that a screen reader would read without a name. */
async function nameless(page, context) {
  const session = await context.newCDPSession(page);
  const { nodes } = await session.send('Accessibility.getFullAXTree');
  await session.detach();
  const named = nodes.filter((n) => !n.ignored && roles.has(n.role?.value));
  assert.ok(named.length > 10);
  return named.filter((n) => !n.name?.value.trim()).map((n) => `${n.role.value} ${JSON.stringify(n.properties?.slice(0, 2))}`);
}

/** What Tab reaches from the top of the page, once around. */
async function walked(page) {
  const reached = new Set();
  await page.evaluate(() => { document.activeElement?.blur(); window.getSelection()?.removeAllRanges(); });
  for (let i = 0; i < 200; ++i) {
    await page.keyboard.press('Tab');
    const at = await page.evaluate(() => {
      const e = document.activeElement;
      if (!e || e === document.body) return '';
      return e.id ? `#${e.id}` : e.dataset.path ?? e.getAttribute('aria-label') ?? e.textContent.trim().slice(0, 40);
    });
    if (at === 'deck') await page.keyboard.press('Escape'); // Tab indents there
    if (at === '' || (reached.has(at) && i > 60)) break;
    reached.add(at);
  }
  return reached;
}

/** Contrast of every visible text that is not a picture, with what is painted below it; those under 4.5. */
const faint = (page) => page.evaluate(() => {
  const ctx = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
  const rgba = (colour) => {
    ctx.clearRect(0, 0, 1, 1);
    ctx.fillStyle = colour;
    ctx.fillRect(0, 0, 1, 1);
    const [r, g, b, a] = ctx.getImageData(0, 0, 1, 1).data;
    return [r, g, b, a / 255];
  };
  const over = (top, below) => [0, 1, 2].map((k) => top[k] * top[3] + below[k] * (1 - top[3])).concat(1);
  const background = (e) => {
    const layers = [];
    for (let at = e; at; at = at.parentElement) layers.push(rgba(getComputedStyle(at).backgroundColor));
    return layers.reverse().reduce((below, top) => over(top, below), [255, 255, 255, 1]);
  };
  const light = (c) => [0.2126, 0.7152, 0.0722].reduce((sum, w, k) => {
    const v = c[k] / 255;
    return sum + w * (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
  }, 0);
  const found = new Map();
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let n = walker.nextNode(); n; n = walker.nextNode()) {
    const e = n.parentElement;
    if (!n.textContent.trim() || ['SCRIPT', 'STYLE', 'OPTION', 'OPTGROUP'].includes(e.tagName)) continue;
    if (e.getClientRects().length === 0 || getComputedStyle(e).visibility === 'hidden') continue;
    let opacity = 1;
    for (let at = e; at; at = at.parentElement) opacity *= Number(getComputedStyle(at).opacity);
    if (opacity === 0) continue;
    const below = background(e);
    const own = rgba(getComputedStyle(e).color);
    const [a, b] = [light(over([...own.slice(0, 3), own[3] * opacity], below)), light(below)].sort((x, y) => y - x);
    const contrast = (a + 0.05) / (b + 0.05);
    if (contrast < 4.5) found.set(`${e.tagName}.${e.className} in ${e.closest('[id]')?.id} "${n.textContent.trim().slice(0, 30)}"`, contrast.toFixed(2));
  }
  return [...found].map(([where, contrast]) => `${where}: ${contrast}`);
});

const tabs = ['notes', 'checks', 'values', 'plots', 'report'];
const motion = (page) => page.locator('#examples option', { hasText: /recoil|drop/i }).first().innerText();

test('every control has a name in the accessibility tree', async () => {
  const { page, context } = await opened();
  const look = async (state) => assert.deepEqual(await nameless(page, context), [], state);
  for (const tab of tabs) {
    await page.click(`#choose-${tab}`);
    await page.waitForTimeout(200);
    await look(tab);
  }
  await page.locator('.cm-line', { hasText: 'mass: 900 kg' }).click();
  await look('form');
  await page.locator('#view').selectOption('space');
  await look('space');
  await page.locator('#view').selectOption('side');
  await page.keyboard.press('Control+f');
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+f');
  await page.waitForSelector('.cm-search');
  await look('search');
  await page.keyboard.press('Escape');
  await example(page, await motion(page));
  await page.click('#choose-notes');
  await look('motion');
  await write(page, (await text(page)).replace('taut: 1', 'taut: 1\nx: 1'));
  await page.waitForSelector('.error');
  await look('mistakes');
  await context.close();
});

test('the keyboard reaches every control, and the verdict is spoken', async () => {
  const { page, context } = await opened();
  await example(page, await motion(page));
  const reached = await walked(page);
  for (const one of ['#examples', '#open', '#save', '#share', '#theme', 'deck', '#view', '#play', '#time', '#choose-notes']) {
    assert.ok(reached.has(one), `${one} of ${[...reached]}`);
  }
  const handles = await page.locator('.handle').evaluateAll((all) => all.map((h) => h.dataset.path));
  for (const path of handles) assert.ok(reached.has(path), path);
  assert.equal(await page.locator('#verdict').getAttribute('aria-live'), 'polite');
  // the tabs by arrow keys, each with its panel
  await page.locator('#choose-notes').focus();
  for (const tab of [...tabs.slice(1), tabs[0]]) {
    await page.keyboard.press('ArrowRight');
    assert.ok(await page.locator(`#tab-${tab}`).isVisible(), tab);
    assert.equal(await page.evaluate(() => document.activeElement.id), `choose-${tab}`);
  }
  await context.close();
});

test('whatever scrolls can be scrolled by keyboard', async () => {
  const { page, context } = await opened();
  await page.click('#choose-values');
  await page.locator('#choose-values').focus();
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'tab-values');
  await page.keyboard.press('End');
  await page.waitForFunction(() => document.getElementById('tab-values').scrollTop > 0);
  await context.close();
});

for (const colorScheme of ['light', 'dark']) {
  test(`every text has a contrast of 4.5 in ${colorScheme}`, async () => {
    const { page, context } = await opened('', { colorScheme });
    for (const tab of tabs) {
      await page.click(`#choose-${tab}`);
      await page.waitForTimeout(100);
      assert.deepEqual(await faint(page), [], tab);
    }
    await page.locator('.cm-line', { hasText: 'mass: 900 kg' }).click();
    assert.deepEqual(await faint(page), [], 'form');
    await page.keyboard.press('Control+a');
    assert.deepEqual(await faint(page), [], 'selection');
    await page.keyboard.press('Control+f');
    await page.waitForSelector('.cm-search');
    assert.deepEqual(await faint(page), [], 'search');
    await page.keyboard.press('Escape');
    const deck = await text(page);
    await page.click('#choose-notes');
    await write(page, `${deck.replace('mass: 900 kg', 'mas: 900 kg')}`);
    await page.waitForSelector('.error');
    assert.deepEqual(await faint(page), [], 'mistake');
    // the answer of before is greyed, and can be read
    for (const tab of ['checks', 'values', 'plots']) {
      await page.click(`#choose-${tab}`);
      await page.waitForTimeout(300);
      assert.deepEqual(await faint(page), [], `old ${tab}`);
    }
    await write(page, `${deck}\n`);
    await settled(page);
    await page.keyboard.press('Control+Home');
    await page.keyboard.press('Control+Space');
    await page.waitForSelector('.cm-tooltip-autocomplete li', { timeout: 60000 });
    await page.waitForTimeout(300);
    assert.deepEqual(await faint(page), [], 'completion');
    await context.close();
  });
}
