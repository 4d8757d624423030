// Opens report.html in Chromium and uses it: open_page.mjs PAGE CHROMIUM FOLDER. Prints what is wrong, one line each.
// Writes page.pdf, light.png, dark.png and, with what it marked in the review queue, decisions.geojson to FOLDER.
import { chromium } from 'playwright-core';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

const [, , page, program, folder] = process.argv;
const browser = await chromium.launch({
  executablePath: program,
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
const faults = [];
const expect = (holds, what) => { if (!holds) faults.push(what); };

async function open(colorScheme) {
  const tab = await (await browser.newContext({ viewport: { width: 1240, height: 900 }, colorScheme })).newPage();
  tab.on('pageerror', (error) => faults.push(`error: ${error.message}`));
  tab.on('console', (message) => { if (message.type() === 'error') faults.push(`console: ${message.text()}`); });
  tab.on('dialog', (dialog) => { faults.push('a text of the report ran as a script'); dialog.dismiss(); });
  tab.on('request', (request) => {
    if (!/^(file|blob):/.test(request.url())) faults.push(`request: ${request.url()}`);
  });
  await tab.goto(`file://${page}`);
  await tab.waitForSelector('body[data-pictures=ready]', { timeout: 60000 });
  return tab;
}

// The sum of the canvas' bytes: another picture has another one.
const pixels = (tab) => tab.locator('.view:not(.print)').first().evaluate((canvas) => canvas
  .getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.reduce((sum, value) => sum + value, 0));

// Tables that are wider than the page.
const cut = (page) => page.locator('.scroll').evaluateAll((list) => list.filter((box) => box.scrollWidth > box.clientWidth).length);

const tab = await open('light');
expect(await tab.locator('.verdict').count() === 1, 'no verdict');
expect(await tab.locator('svg.map rect').count() === 2, 'the map has not a square for each cell');
expect(await tab.locator('.card[data-loaded=yes]').count() >= 1, 'no picture was loaded');
const seen = new Set();
for (const mode of ['before', 'after', 'marked']) {
  await tab.locator('.card .modes button', { hasText: mode }).first().click();
  seen.add(await pixels(tab));
}
expect(seen.size === 3, `before, after and marked show ${seen.size} pictures`);
const marked = await pixels(tab), canvas = await tab.locator('.view:not(.print)').first().boundingBox();
await tab.mouse.move(canvas.x + 200, canvas.y + 150);
await tab.mouse.down();
await tab.mouse.move(canvas.x + 320, canvas.y + 170, { steps: 4 });
await tab.mouse.up();
const turned = await pixels(tab);
expect(turned !== marked, 'dragging does not turn the picture');
await tab.locator('.card .above').first().click();
expect(![marked, turned].includes(await pixels(tab)), 'the picture is not seen from above');

const rows = tab.locator('table.holes tbody tr');
const all = await rows.count();
expect(all === 2, `the table has ${all} holes`);
const area = () => rows.first().locator('td').nth(4).innerText();
await tab.locator('table.holes th button', { hasText: 'area' }).click();
const largest = Number((await area()).replaceAll('\u2009', ''));
await tab.locator('table.holes th button', { hasText: 'area' }).click();
expect(Number((await area()).replaceAll('\u2009', '')) < largest, 'the table is not sorted by area');
await tab.locator('.filters input[type=search]').fill('no such text');
expect(await rows.count() === 0, 'the filter shows what does not match');
await tab.locator('svg.map rect').first().click();
expect(await rows.count() >= 1, 'a click on a cell does not show its holes');
expect((await tab.locator('main').innerText()).includes('<img src=x onerror=alert(1)>'), 'a text with markup is not shown as it is');

const waterAreas = await tab.locator('section:has(> h2:text-is("Waters")) tbody td:nth-child(5)').allInnerTexts();
expect(waterAreas.join() === '12.3,< 0.1,0.0', `a column of areas has ${waterAreas}`);

// The review queue: marked by keys, kept over a reload, written as a file.
const queued = (page) => page.locator('table.queue tbody tr'), load = (page) => page.locator('.review .download');
expect(await queued(tab).count() === 2, 'the queue has not both holes');
expect(await cut(tab) === 0, 'a table is cut');
const link = queued(tab).first().locator('a'), hole = await link.innerText();
await link.click();
expect(await tab.locator(`#picture-${hole}:target figcaption`, { hasText: `hole ${hole},` }).count() === 1, 'the queue has no link to a picture');
expect(await load(tab).isDisabled(), 'nothing is decided, and it can be downloaded');
await queued(tab).first().focus();
await tab.keyboard.press('w');
const level = queued(tab).first().locator('input');
for (const wrong of ['about 1', '1e300']) {
  await level.fill(wrong);
  expect(await load(tab).isDisabled() && await level.getAttribute('aria-invalid') === 'true', `the level ${wrong} is taken`);
}
await level.fill('1.25');
await tab.keyboard.press('Enter');
await tab.keyboard.press('ArrowDown');
await tab.keyboard.press('o');
expect((await tab.locator('.review [role=status]').innerText()).startsWith('2 of 2 fills decided'), 'the queue does not count what is decided');
await tab.reload();
await tab.waitForSelector('body[data-pictures=ready]', { timeout: 60000 });
expect(await queued(tab).nth(1).locator('select').inputValue() === 'open', 'a decision is lost when the page is opened again');

// Two tabs of one report: neither writes its marks over those of the other.
const other = await tab.context().newPage();
await other.goto(`file://${page}`);
await other.waitForSelector('table.queue tbody tr');
await queued(other).first().focus();
await other.keyboard.press('x');
await tab.waitForFunction(() => document.querySelector('table.queue select')?.value === '', null, { timeout: 5000 })
  .catch(() => faults.push('a tab does not hear of what another one decides'));
await queued(tab).first().focus();
await tab.keyboard.press('w');
await queued(tab).first().locator('input').fill('1,25');
await other.keyboard.press('ArrowDown');
await other.keyboard.press('g');
await other.keyboard.press('o');
await other.close();
await tab.reload();
await tab.waitForSelector('body[data-pictures=ready]', { timeout: 60000 });
expect((await Promise.all([0, 1].map((k) => queued(tab).nth(k).locator('select').inputValue()))).join() === 'water,open',
  'a tab writes its marks over those of another');
const command = await tab.locator('.command code').innerText();
expect(/^tilemend run .*scene --out .*out --decisions decisions.geojson$/.test(command), `the command is ${command}`);
expect(await tab.locator('.verdict + .warnings li').count() === 2, 'the warnings do not stand below the verdict');
const [file] = await Promise.all([tab.waitForEvent('download'), load(tab).click()]);
await file.saveAs(join(folder, 'decisions.geojson'));
await tab.screenshot({ path: join(folder, 'light.png') });
// On paper of A4, upright.
await tab.emulateMedia({ media: 'print' });
await tab.setViewportSize({ width: 718, height: 1000 });
expect(await cut(tab) === 0, 'a table is cut on paper');
const hints = await tab.locator('.hint').evaluateAll((list) => list.map((hint) => hint.checkVisibility()));
expect(hints.length > 0 && !hints.includes(true), 'a hint for mouse and keys is printed');
const reasons = await tab.locator('table.holes td:last-child').evaluateAll((list) => list.map((cell) => cell.getBoundingClientRect().width));
expect(Math.min(...reasons) > 200, `reasons are ${reasons} px wide on paper`);
await tab.emulateMedia({ media: null });
await tab.pdf({ path: join(folder, 'page.pdf'), format: 'A4' });
expect(readFileSync(join(folder, 'page.pdf')).length > 10000, 'nothing was printed');

// A narrow screen: no row of the table needs a third of it, and the page does not scroll sideways.
await tab.setViewportSize({ width: 420, height: 900 });
const heights = await rows.evaluateAll((list) => list.map((row) => row.getBoundingClientRect().height));
expect(Math.max(...heights) < 150, `rows are ${heights} px high on a narrow screen`);
expect(await tab.evaluate(() => document.documentElement.scrollWidth) <= 420, 'the page is wider than a narrow screen');
await (await open('dark')).screenshot({ path: join(folder, 'dark.png') });
await browser.close();
for (const fault of faults) console.log(fault);
process.exit(faults.length > 0 ? 1 : 0);
