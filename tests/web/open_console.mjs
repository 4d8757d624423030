// Opens the coordinator's page in Chromium and uses it: open_console.mjs URL CHROMIUM FOLDER STEP. Prints what is wrong,
// one line each. Writes STEP.png to FOLDER. Waits for a line on its input where the test has to do something.
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { Console } from './console_tab.mjs';

const [, , url, program, folder, chosen] = process.argv;
const lines = createInterface({ input: process.stdin })[Symbol.asyncIterator]();
const ask = async (what) => { console.log(`DO ${what}`); await lines.next(); };
const page = await Console.start(url, program);
const expect = page.expect.bind(page);

const tab = await page.open('light', 'ann', chosen);
const job = (name) => tab.locator('.job', name ? { hasText: name } : {});
expect(await job().count() === 6, `${await job().count()} jobs are shown`);
expect(await job('broken').locator('.state').innerText() !== 'partial' && await job('lakes').locator('.state').innerText() === 'done',
  'the states are not in the words of the command line');
await tab.waitForSelector('table.holes tbody tr', { timeout: 20000 });
const cells = await tab.locator('svg.map rect').count();
expect(cells === 12, `the map has ${cells} cells`);
expect(await tab.locator('svg.map rect.written').count() >= 8, 'cells are not shown as written');

// The map and the holes show each other.
const rows = tab.locator('table.holes tbody tr');
const all = await rows.count();
await tab.locator('svg.map rect').first().click();
const ofCell = tab.locator('.filters button', { hasText: 'cell' });
expect(await rows.count() < all, 'a click on a cell does not choose its holes');
expect(await tab.locator('.filters input[type=search]').inputValue() === '', 'a click on a cell changes what was filtered for');
await ofCell.click();
expect(await rows.count() === all && await ofCell.isHidden(), 'the holes of all cells do not come back');
await tab.locator('.filters input.least').first().fill('10');
expect(await rows.count() < all && await rows.count() > 0, 'the least area does not choose');
await rows.first().click();
expect(await tab.locator('svg.map rect.chosen').count() === 1, 'a click on a hole does not mark its cell');
await tab.locator('.detail button', { hasText: 'before and after' }).click();
await tab.waitForSelector('.detail .card[data-loaded=yes]', { timeout: 20000 });
const pixels = () => tab.locator('.detail .view:not(.print)').evaluate((canvas) => canvas
  .getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.reduce((sum, value) => sum + value, 0));
const pictures = new Set();
for (const mode of ['before', 'after', 'marked']) {
  await tab.locator('.detail .modes button', { hasText: mode }).click();
  pictures.add(await pixels());
}
expect(pictures.size === 3, `before, after and marked show ${pictures.size} pictures`);
await page.checkAccess(tab, 'job');
await tab.evaluate(() => scrollTo(0, 0));
await tab.screenshot({ path: join(folder, 'console_job.png'), fullPage: true });
await tab.locator('svg.map').focus();
await tab.keyboard.press('ArrowRight');
await tab.keyboard.press('Enter');
expect((await tab.locator('.detail p').first().innerText()).startsWith('cell'), 'the keyboard chooses no cell');
expect((await tab.locator('main').innerText()).includes('<img src=x onerror=alert(1)>'), 'a name with markup is not shown as it is');

// A job that failed says where and why, with the lines of the log.
await job('broken').locator('.name').click();
await tab.waitForSelector('table.failures tbody tr', { timeout: 20000 });
const failure = await tab.locator('table.failures tbody tr').first().innerText();
expect(/1, 0/.test(failure) && /expected/.test(failure), `the failure is not told: ${failure}`);
expect(/warning attempt failed.*worker=/.test(failure), `the failure is told without the log: ${failure}`);
await tab.locator('table.failures button').first().click();
expect(await tab.locator('svg.map rect.failed.chosen').count() === 1, 'a failure does not lead to its cell');
await tab.locator('.joblog summary').click();
expect((await tab.locator('.joblog pre').innerText()).includes('job created'), 'the log of the job is not shown');
await page.checkAccess(tab, 'failure');
await tab.screenshot({ path: join(folder, 'console_failure.png') });

// Holes are shown once they are planned.
await job('planned').locator('.name').click();
await tab.waitForSelector('table.holes tbody tr', { timeout: 20000 });
await tab.waitForFunction(() => document.querySelector('.jobview h2')?.textContent.length > 0 && document.querySelectorAll('svg.map rect').length === 144);
expect(await tab.locator('table.holes td', { hasText: /^planned$/ }).count() > 0, 'no hole is shown as planned');
await tab.locator('table.holes tbody tr').first().click();
await tab.locator('.detail button', { hasText: 'before and after' }).click();
await tab.waitForSelector('.detail .card[data-loaded=yes]', { timeout: 20000 });
expect((await tab.locator('.detail .card p').innerText()).includes('not written yet'), 'a tile that is not written is not told');
await tab.evaluate(() => scrollTo(0, document.querySelector('.jobview').offsetTop - 10));
await tab.screenshot({ path: join(folder, 'console_planned.png') });

// A map of 100,000 cells zooms.
await job('wide').locator('.name').click();
await tab.waitForSelector('canvas.map', { timeout: 30000 });
// The median of what a frame of the map takes while it is zoomed.
const frames = () => tab.locator('canvas.map').evaluate(async (canvas) => {
  const times = [];
  for (let k = 0; k < 40; ++k) {
    canvas.dispatchEvent(new WheelEvent('wheel', { deltaY: k % 8 < 4 ? -1 : 1, clientX: 300, clientY: 300, cancelable: true }));
    times.push(await new Promise((done) => requestAnimationFrame(() => done(window.frameTime))));
  }
  return times.sort((a, b) => a - b)[20];
});
await tab.locator('canvas.map').focus();
const smooth = await frames();
console.log(`100,000 cells: a frame takes ${smooth.toFixed(1)} ms`);
expect(smooth < 50, `a frame of a map of 100,000 cells takes ${smooth} ms`);
const sum = () => tab.locator('canvas.map').evaluate((canvas) => canvas.getContext('2d')
  .getImageData(0, 0, canvas.width, canvas.height).data.reduce((total, value, i) => (total * 31 + value * (i % 7)) % 1000003, 0));
const shown = async () => { await tab.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))); return sum(); };
const sums = [await shown()];
for (const name of ['zoom in', 'zoom in', 'zoom in', 'zoom in']) {
  await tab.locator(`.zoom button[aria-label="${name}"]`).click();
  sums.push(await shown());
}
expect(new Set(sums).size === 5, `the map does not zoom: ${sums}`);
await tab.locator('canvas.map').focus();
await tab.keyboard.press('ArrowRight');
await tab.keyboard.press('Enter');
expect((await tab.locator('.detail p').first().innerText()).startsWith('cell 0, 0'), 'the keyboard chooses no cell of a large map');
const box = await tab.locator('canvas.map').boundingBox(), before = await shown();
await tab.mouse.move(box.x + 300, box.y + 200);
await tab.mouse.down();
await tab.mouse.move(box.x + 200, box.y + 300, { steps: 5 });
await tab.mouse.up();
expect(await shown() !== before, 'dragging does not move the map');
await page.checkAccess(tab, 'map');
await tab.evaluate(() => scrollTo(0, document.querySelector('.jobview').offsetTop - 10));
await tab.screenshot({ path: join(folder, 'console_wide.png') });
// A map of 1,000,000 cells in its place.
await tab.route('**/cells', (route) => route.fulfill({ json: {
  state: 'running', column: 0, row: 0, columns: 1000, rows: 1000, cellSize: [1, 1], hasTiles: true,
  cells: '.spfFwx-wwww'.repeat(90000).slice(0, 1000000), held: [], failures: [] } }));
await tab.waitForFunction(() => (document.querySelector('.legend')?.children.length ?? 0) >= 8, null, { timeout: 30000 });
await tab.locator('canvas.map').focus();
const million = await frames();
console.log(`1,000,000 cells: a frame takes ${million.toFixed(1)} ms`);
expect(million < 50, `a frame of a map of 1,000,000 cells takes ${million} ms`);
await tab.screenshot({ path: join(folder, 'console_million.png') });
await tab.unroute('**/cells');

// A large map, and steering.
const large = job('large');
await large.locator('.name').click();
await tab.waitForFunction(() => document.querySelectorAll('svg.map rect').length === 10000, null, { timeout: 30000 });
expect(await large.locator('.state').innerText() === 'paused', 'the paused job is not shown as paused');
await large.locator('button', { hasText: 'resume' }).click();
await tab.waitForFunction(() => [...document.querySelectorAll('.job')].some((j) => j.textContent.includes('large') && j.querySelector('button[hidden]') && j.textContent.includes('pause') && !j.querySelector('.state').textContent.includes('paused')));
await large.locator('button', { hasText: 'pause' }).click();
await tab.waitForFunction(() => document.querySelector('.job.chosen .state')?.textContent === 'paused');
await large.locator('.priority').fill('7');
await large.locator('.priority').blur();
expect(await tab.locator('td.doing').count() >= 1, 'no worker is shown');
await tab.evaluate(() => scrollTo(0, 0));
await tab.screenshot({ path: join(folder, 'console_large.png') });

// The coordinator is killed and comes back.
page.mayFail = true;
await ask('kill');
await tab.waitForFunction(() => document.querySelector('[role=alert]')?.textContent.includes('does not answer'), null, { timeout: 20000 });
expect(await job().count() === 6, 'the jobs are gone while the coordinator is down');
await ask('start');
await tab.waitForFunction(() => document.querySelector('[role=alert]')?.hidden, null, { timeout: 30000 });
page.mayFail = false;
expect(await large.locator('.priority').inputValue() === '7', 'the priority was not kept');
await large.locator('button', { hasText: 'cancel' }).click();
await large.locator('button', { hasText: 'really' }).blur();
expect(await large.locator('button', { hasText: 'really' }).count() === 0, 'a question stands after its button lost the focus');
await large.locator('button', { hasText: 'cancel' }).click();
await large.locator('button', { hasText: 'really' }).click();
await tab.waitForFunction(() => document.querySelector('.job.chosen .state')?.textContent === 'cancelled', null, { timeout: 20000 });
expect(await tab.locator('svg.map rect.unknown').count() === 0, 'cells of a job that was cancelled now are not known');

// An output that is there is replaced only after a second click.
await job('lakes').locator('.name').click();
await job('lakes').locator('button', { hasText: 'retry' }).first().click();
await job('lakes').locator('button', { hasText: 'replace its output?' }).waitFor({ timeout: 20000 });
expect(await job().count() === 6, 'a job that is retried replaced an output unasked');
await tab.waitForSelector(`.jobview[data-job="${chosen}"]`);
await tab.waitForSelector('table.holes tbody tr', { timeout: 20000 });
const written = await tab.waitForFunction(() => document.querySelectorAll('svg.map rect.written').length >= 8, null,
  { timeout: 20000 }).catch(() => null);
expect(written, 'after a restart cells are not shown as written');

// The warnings of the report stand at the top of the job.
await tab.route('**/holes', async (route) => {
  const answer = await route.fetch({ headers: { ...route.request().headers(), 'if-none-match': '' } });
  await route.fulfill(answer.ok() ? { json: { ...await answer.json(), warnings: ['one <b>', 'two'] } } : { response: answer });
});
await tab.waitForSelector('.jobview .warnings li', { timeout: 20000 })
  .catch(() => expect(false, 'the warnings of the report are not shown'));
expect(await tab.locator('.jobview > h2 + div .warnings li').count() === 2, 'the warnings do not stand at the top of the job');
await tab.unroute('**/holes');

// A cell without a tile that the report tells to be filled is shown as written: after a restart only the report knows.
await tab.route('**/cells', async (route) => {
  const answer = await route.fetch({ headers: { ...route.request().headers(), 'if-none-match': '' } }), json = await answer.json();
  await route.fulfill({ json: { ...json, cells: json.cells.replace('w', '-') } });
});
const polls = () => tab.evaluate(() => Number(document.body.dataset.polls));
const seen = await polls();
await tab.waitForFunction((n) => Number(document.body.dataset.polls) >= n, seen + 2, { timeout: 20000 });
expect(await tab.locator('svg.map rect.empty').count() === 0 && !(await tab.locator('.legend').innerText()).includes('no tile'),
  'a cell that has got a tile by its fill is shown without one');
await tab.unroute('**/cells');

// Has the list of jobs tell something else of the chosen one.
const tell = (change) => tab.route('**/v1/jobs?*', async (route) => {
  const answer = await route.fetch({ headers: { ...route.request().headers(), 'if-none-match': '' } }), list = await answer.json();
  for (const j of list.jobs) if (j.name === chosen) change(j);
  await route.fulfill({ json: list });
});

// How fast a job goes and how long it takes is told in its first stage, where no cell is written yet: a third is done.
const began = Date.now() - 20_000;
await tell((j) => Object.assign(j, { state: 'RUNNING', createTime: new Date(began).toISOString(),
  progress: { ...j.progress, phase: 'survey', cells: '90', cellsDone: '0', tasks: '90', tasksDone: '90' } }));
const speed = tab.locator('.job.chosen .speed');
await speed.filter({ hasText: /^[0-9.]+ tasks\/s, \d+ (s|min .*) left$/ }).waitFor({ timeout: 20000 })
  .catch(async () => expect(false, `a job in its first stage does not say how long it takes: ${await speed.innerText()}`));
const share = await tab.locator('.job.chosen progress').evaluate((bar) => bar.value);
expect(Math.abs(share - 1 / 3) < 0.01, `the bar of a job of which a third is done shows ${share}`);
await tab.unroute('**/v1/jobs?*');

// A partial job says what is left, and looks so.
await tell((j) => Object.assign(j, { state: 'PARTIAL', progress: { ...j.progress, holes: '5', holesFilled: '3' } }));
await tab.locator('.job.partial .state', { hasText: /^done, 2 left open$/ }).waitFor({ timeout: 20000 })
  .catch(() => expect(false, 'a partial job does not say how many holes are left'));
await tab.unroute('**/v1/jobs?*');

// A review queue that is open goes with its report: another program writes the report again, then a later job does.
const queue = tab.locator('.jobview .review');
await rows.first().click();
await tab.locator('.detail button', { hasText: 'decide on it' }).click();
await queue.waitFor({ timeout: 20000 });
await queue.locator('table.queue select').first().selectOption('open');
// In a narrow window neither table is cut, and a reason has more than the width of a word.
const size = tab.viewportSize();
await tab.setViewportSize({ width: 800, height: 600 });
const narrow = await tab.evaluate(() => [...document.querySelectorAll('table.holes, table.queue')].map((table) =>
  [table.className, table.parentElement.scrollWidth - table.parentElement.clientWidth, Math.max(...[...table.rows].map((row) => row.offsetHeight))]));
expect(narrow.length === 2 && narrow.every(([, cut, height]) => cut <= 1 && height < 130), `in a narrow window the tables are cut: ${JSON.stringify(narrow)}`);
await page.checkAccess(tab, 'narrow');
await tab.setViewportSize(size);
await ask('run_again');
await tab.locator('.jobview [role=status]', { hasText: 'The report was written again.' }).waitFor({ timeout: 20000 })
  .catch(() => expect(false, 'an open review queue does not tell that its report was written again'));
expect(await queue.count() === 1 && await queue.locator('button.download').isDisabled(),
  'the queue of the new report has the decisions of the old one');
await ask('submit_again');
const link = tab.locator('.jobview .warning a', { hasText: /^Show jobs\// });
await link.waitFor({ timeout: 20000 }).catch(() => expect(false, 'a review queue does not close when a later job has written its output'));
expect(await queue.count() === 0, 'the review queue of a replaced report stays open');
expect(await rows.count() === 0, 'holes of another job are shown');
expect((await tab.locator('main').innerText()).includes('written again by jobs/'), 'who wrote the output again is not told');
await tab.screenshot({ path: join(folder, 'console_replaced.png'), fullPage: true });
await link.click();
await tab.waitForFunction((old) => !['', old].includes(document.querySelector('.jobview')?.dataset.job ?? ''), chosen, { timeout: 20000 });
await tab.waitForSelector('table.holes tbody tr', { timeout: 20000 });

// Who may watch alone has no buttons.
const watcher = await page.open('dark', 'eve', chosen);
await watcher.waitForSelector('.job');
expect(await watcher.locator('.steer:not([hidden])').count() === 0, 'who may watch alone is shown buttons');
await page.checkAccess(watcher, 'dark');
await watcher.screenshot({ path: join(folder, 'console_dark.png') });

// Who gave a token that may not watch, or is none, can give another.
const alerts = watcher.locator('[role=alert]:not([hidden])');
await watcher.locator('button', { hasText: 'forget the token' }).click();
for (const [token, told] of [['wrk', 'role'], ['ev\u2026', 'ASCII']]) {
  await watcher.waitForSelector('.login:not([hidden])', { timeout: 20000 });
  await watcher.locator('#token').fill(token);
  await watcher.locator('.login button').click();
  await alerts.filter({ hasText: told }).waitFor({ timeout: 20000 });
  expect(!(await watcher.locator('header').innerText()).includes('eve'), 'who has gone is still named');
}
await watcher.locator('#token').fill('eve');
await watcher.locator('.login button').click();
await watcher.waitForSelector('.job', { timeout: 20000 });
await watcher.waitForFunction(() => !document.querySelector('[role=alert]:not([hidden])'), null, { timeout: 20000 })
  .catch(() => expect(false, 'a fault is told that is over'));
await page.end();
