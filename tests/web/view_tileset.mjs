// Draws a tileset in Chromium: view_tileset.mjs PAGE TILESET_FOLDER CHROMIUM PICTURE [QUERY]. Run it where the npm
// packages are; PAGE is the page's script. Prints what was drawn as JSON: faults, models, triangles, the share of pixels
// that are not background, and the colour at the scene's middle if the page says where that is.
import { chromium } from 'playwright-core';
import { build } from 'esbuild';
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { extname, join, normalize } from 'node:path';

const [, , entry, folder, program, picture, query = ''] = process.argv;
const bundle = await build({
  entryPoints: [entry], bundle: true, write: false, format: 'esm', external: ['fs', 'path', 'url', 'module'],
  define: { 'import.meta.url': 'document.baseURI', CESIUM_BASE_URL: '"/cesium/"' }, logLevel: 'error' });
const script = bundle.outputFiles[0].text;
const page = '<!doctype html><meta charset=utf-8><link rel=icon href="data:,"><body style="margin:0"><script type=module src=/page.js></script>';
const types = { '.json': 'application/json', '.glb': 'model/gltf-binary', '.js': 'text/javascript', '.wasm': 'application/wasm' };
// Files of CesiumJS that it loads itself.
const cesium = (path) => join('node_modules/@cesium/engine', path.startsWith('/Assets/') ? 'Source' : 'Build', path);
const faults = [];
const server = createServer(async (request, response) => {
  const path = decodeURIComponent(new URL(request.url, 'http://x').pathname);
  if (path === '/') return response.setHeader('content-type', 'text/html').end(page);
  if (path === '/page.js') return response.setHeader('content-type', 'text/javascript').end(script);
  try {
    const own = path.startsWith('/cesium/') ? cesium(normalize(path.slice(7))) : join(folder, normalize(path));
    const bytes = await readFile(own);
    response.setHeader('content-type', types[extname(path)] ?? 'application/octet-stream').end(bytes);
  } catch {
    if (path !== '/favicon.ico') faults.push(`not found: ${path}`);
    response.writeHead(404).end();
  }
});
await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
const browser = await chromium.launch({
  executablePath: program,
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
const tab = await browser.newPage({ viewport: { width: 1000, height: 640 } });
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
// The share of the picture that the tileset covers, and the colour at its middle.
[result.drawn, result.colour] = await tab.evaluate((middle) => {
  const canvas = document.createElement('canvas'), source = document.querySelector('canvas');
  if (!source) return [0, null];
  [canvas.width, canvas.height] = [source.width, source.height];
  const context = canvas.getContext('2d');
  context.drawImage(source, 0, 0);
  const pixels = context.getImageData(0, 0, canvas.width, canvas.height).data;
  let covered = 0;
  for (let at = 0; at < pixels.length; at += 4) {
    if (pixels[at] < 250 || pixels[at + 1] > 5 || pixels[at + 2] < 250) ++covered;
  }
  const colour = middle ? [...context.getImageData(...middle, 1, 1).data] : null;
  return [covered / (pixels.length / 4), colour];
}, result.middle);
await tab.screenshot({ path: picture });
await browser.close();
server.close();
console.log(JSON.stringify(result));
