// Accepts the first fill of a page's review queue and downloads the decisions: mark_fill.mjs PAGE CHROMIUM FILE.
import { chromium } from 'playwright-core';

const [, , page, program, file] = process.argv;
const browser = await chromium.launch({ executablePath: program, args: ['--no-sandbox'] });
const tab = await browser.newPage();
await tab.goto(`file://${page}`);
await tab.locator('table.queue tbody tr').first().focus();
await tab.keyboard.press('a');
await tab.waitForSelector('.earlier tbody tr input', { timeout: 20000 }); // what was decided before can be undone
const [download] = await Promise.all([tab.waitForEvent('download'), tab.locator('.review .download').click()]);
await download.saveAs(file);
await browser.close();
