// Draws a tileset in Chromium: view_tileset.mjs TILESET_FOLDER CHROMIUM PICTURE [QUERY]. Run it where the npm packages
// are. Prints what was drawn as JSON: faults, models, triangles, the share of pixels that are not background.
import { chromium } from 'playwright-core';
import { build } from 'esbuild';
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { extname, join, normalize } from 'node:path';

const [, , folder, program, picture, query = ''] = process.argv;
const bundle = await build({
  entryPoints: ['tileset_page.js'], bundle: true, write: false, format: 'iife',
  define: { 'import.meta.url': 'document.baseURI' }, logLevel: 'error' });
const script = bundle.outputFiles[0].text;
const page = '<!doctype html><meta charset=utf-8><link rel=icon href="data:,"><body style="margin:0"><script src=/page.js></script>';
const types = { '.json': 'application/json', '.glb': 'model/gltf-binary' };
const server = createServer(async (request, response) => {
  const path = decodeURIComponent(new URL(request.url, 'http://x').pathname);
  if (path === '/') return response.setHeader('content-type', 'text/html').end(page);
  if (path === '/page.js') return response.setHeader('content-type', 'text/javascript').end(script);
  try {
    const bytes = await readFile(join(folder, normalize(path)));
    response.setHeader('content-type', types[extname(path)] ?? 'application/octet-stream').end(bytes);
  } catch {
    response.writeHead(404).end();
  }
});
await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
const browser = await chromium.launch({
  executablePath: program,
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
const tab = await browser.newPage({ viewport: { width: 1000, height: 640 } });
const faults = [];
tab.on('pageerror', (error) => faults.push(`error: ${error.message}`));
tab.on('console', (message) => { if (message.type() === 'error') faults.push(`console: ${message.text()}`); });
await tab.goto(`http://127.0.0.1:${server.address().port}/?${query}`);
try {
  await tab.waitForSelector('body[data-drawn=yes]', { timeout: 120000 });
} catch (error) {
  faults.push(`nothing was drawn in time: ${error.message}`);
}
const result = await tab.evaluate(() => window.result) ?? { faults: [], models: 0, triangles: 0 };
result.faults.push(...faults);
// The share of the picture that the tileset covers.
result.drawn = await tab.evaluate(() => {
  const canvas = document.createElement('canvas'), source = document.querySelector('canvas');
  if (!source) return 0;
  [canvas.width, canvas.height] = [source.width, source.height];
  const context = canvas.getContext('2d');
  context.drawImage(source, 0, 0);
  const pixels = context.getImageData(0, 0, canvas.width, canvas.height).data;
  let covered = 0;
  for (let at = 0; at < pixels.length; at += 4) {
    if (pixels[at] < 250 || pixels[at + 1] > 5 || pixels[at + 2] < 250) ++covered;
  }
  return covered / (pixels.length / 4);
});
await tab.screenshot({ path: picture });
await browser.close();
server.close();
console.log(JSON.stringify(result));
