// Adds a hole to the review queue from the table of holes: add_row.mjs PAGE CHROMIUM HOLE TAKEN_FOR. Prints what is wrong.
import { chromium } from 'playwright-core';

const [, , page, program, hole, takenFor] = process.argv;
const browser = await chromium.launch({ executablePath: program, args: ['--no-sandbox'] });
const tab = await browser.newPage();
await tab.goto(`file://${page}`);
await tab.locator(`table.holes tr[data-hole="${hole}"] .decidehole`).click();
const told = await tab.locator(`table.queue tr[data-hole="${hole}"] td`).nth(4).innerText();
await browser.close();
if (told !== takenFor) console.log(`hole ${hole} is taken for "${told}", not for "${takenFor}"`);
process.exit(told === takenFor ? 0 : 1);
