// The coordinator's page in Chromium, for the scripts that use it.
import { chromium } from 'playwright-core';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';

// `program`: the browser. What is wrong goes to `faults`.
export class Console {
  faults = [];
  mayFail = false; // requests, while the coordinator is down

  static async start(url, program) {
    const page = new Console();
    page.url = url;
    page.browser = await chromium.launch({
      executablePath: program,
      args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
    return page;
  }

  expect(holds, what) {
    if (!holds) this.faults.push(what);
  }

  // A tab that shows the job, after `token` was given.
  async open(colorScheme, token, job) {
    const context = await this.browser.newContext({ viewport: { width: 1240, height: 1000 }, colorScheme });
    const tab = await context.newPage();
    tab.on('pageerror', (error) => this.faults.push(`error: ${error.message}`));
    tab.on('console', (message) => {
      if (message.type() === 'error' && !this.mayFail && !/status of (401|403|404|409|503)/.test(message.text())) this.faults.push(`console: ${message.text()}`);
    });
    tab.on('dialog', (dialog) => { this.faults.push('a text ran as a script'); dialog.dismiss(); });
    tab.on('request', (request) => {
      if (!request.url().startsWith(this.url) && !/^(data|blob):/.test(request.url())) this.faults.push(`request: ${request.url()}`);
    });
    await tab.addInitScript(() => { // how long the last callback before a frame took
      const ask = window.requestAnimationFrame.bind(window);
      window.requestAnimationFrame = (callback) => ask((time) => {
        const begin = performance.now();
        callback(time);
        if (!callback.toString().includes('frameTime')) window.frameTime = performance.now() - begin;
      });
    });
    await tab.goto(`${this.url}/#${job}`);
    await tab.waitForSelector('.login:not([hidden])', { timeout: 20000 });
    this.expect(await tab.locator('.jobs').isHidden(), 'jobs are shown before a token is given');
    await tab.locator('#token').fill('wrong');
    await tab.locator('.login button').click();
    await tab.waitForFunction(() => document.querySelector('[role=alert]')?.textContent.includes('not known'));
    await tab.locator('#token').fill(token);
    await tab.locator('.login button').click();
    await tab.waitForSelector('.map', { timeout: 20000 });
    return tab;
  }

  // Serious findings of axe-core, where it is installed.
  async checkAccess(tab, where) {
    const path = createRequire(import.meta.url).resolve.paths('axe-core').map((p) => join(p, 'axe-core/axe.min.js')).find(existsSync);
    if (!path) return console.log('NOTE axe-core is not installed');
    const found = await tab.evaluate(async (source) => {
      new Function(source).call(window);
      const { passes, violations } = await window.axe.run();
      if (passes.length < 10) return [`axe checked only ${passes.length} rules`];
      return violations.map((v) => `${v.impact} ${v.id}: ${v.nodes.slice(0, 2).map((n) => n.html.slice(0, 100)).join(' | ')}`);
    }, readFileSync(path, 'utf8')).catch((error) => [`axe did not run: ${error.message}`]);
    for (const line of found) {
      if (/^(serious|critical|axe)/.test(line)) this.faults.push(`${where}: ${line}`);
      else console.log(`NOTE ${where}: ${line}`);
    }
  }

  async end() {
    await this.browser.close();
    for (const fault of this.faults) console.log(fault);
    process.exit(this.faults.length > 0 ? 1 : 0);
  }
}
