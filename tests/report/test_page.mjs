// SPDX-License-Identifier: GPL-3.0-or-later
// The page of birdstrike report in a real browser: node test_page.mjs PROGRAM CHROMIUM FOLDER_OF_NODE_MODULES
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { Pixels } from './pixels.mjs';

const [program, chromiumPath, modules] = process.argv.slice(2);
const { chromium } = createRequire(path.join(modules, 'package.json'))('playwright-core');
const here = path.dirname(new URL(import.meta.url).pathname);
const folder = mkdtempSync(path.join(tmpdir(), 'birdstrike-report-'));
const quiet = ['--no-first-run', '--disable-quic', '--disable-background-networking', '--disable-component-update', '--disable-sync'];
const software = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

const birdstrike = (...options) => execFileSync(program, options, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
const browsers = [];
async function launch(flags) {
  browsers.push(await chromium.launch({ executablePath: chromiumPath, args: ['--no-sandbox', ...quiet, ...flags] }));
  return browsers.at(-1);
}

// A page whose every word on the console and every request is kept.
async function open(browser, options = {}) {
  const page = await (await browser.newContext({ viewport: { width: 900, height: 640 }, ...options })).newPage();
  page.said = [];
  page.requests = [];
  page.on('console', (message) => page.said.push(message.text()));
  page.on('pageerror', (error) => page.said.push(String(error.stack)));
  page.on('request', (request) => { if (!request.url().startsWith('data:')) page.requests.push(request.url()); });
  await page.goto(pathToFileURL(path.join(folder, 'sheet.html')).href);
  await page.waitForSelector('#view:is(.ready, .unable)');
  return page;
}

function isQuiet(page) {
  assert.deepEqual(page.said, [], 'nothing on the console');
  assert.deepEqual(page.requests, [page.url().split('#')[0]], 'no request but for the page itself');
}

const stage = (page) => Pixels.of(page, '#view-canvas');
const setTime = (page, share) => page.evaluate((s) => {
  const time = document.getElementById('time');
  time.value = Math.round(s * time.max);
  time.dispatchEvent(new Event('input'));
}, share);
const stamp = async (page) => parseFloat(await page.locator('#time-stamp').textContent());

const checks = {
  async 'the case and its numbers are on the page'(browser) {
    const page = await open(browser);
    const summary = JSON.parse(readFileSync(path.join(folder, 'sheet', 'summary.json')));
    assert.equal(await page.locator('h1').textContent(), 'A bird & a <b>sheet</b> </script> "quoted"');
    assert.equal(await page.locator('h1 *').count() + await page.locator('img[src=x]').count(), 0);
    const values = await page.locator('data').evaluateAll((all) => all.map((one) => Number(one.value)));
    for (const wanted of [summary.bird.mass, summary.impulse, summary.peak_pressure.first.value, summary.target.max_deflection,
      summary.target.eroded_elements, summary.energy.balance_error, summary.transducers.axis.peak, summary.steps])
      assert(values.includes(wanted), `${wanted} of summary.json`);
    assert(await page.locator('.chart polyline').count() >= 8);
    isQuiet(page);
  },

  async 'the view draws, and follows slider, play, drag and buttons'(browser) {
    const page = await open(browser);
    const first = await stage(page);
    assert(first.colours() > 12, `${first.colours()} colours`);
    assert.equal(await stamp(page), 0);
    await setTime(page, 0.5);
    const half = await stage(page);
    assert.equal(await stamp(page), 0.5);
    assert(half.differs(first) > 0.01, 'time moves the picture');

    await page.click('#play');
    await page.waitForFunction(() => parseFloat(document.getElementById('time-stamp').textContent) > 0.7);
    await page.click('#play');
    const paused = await stamp(page);
    await page.waitForTimeout(400);
    assert.equal(await stamp(page), paused, 'pause holds');
    await page.click('#play');
    await page.waitForFunction(() => document.getElementById('play').textContent === 'Play');
    assert.equal(await stamp(page), 1, 'play stops at the end');

    await setTime(page, 0.5);
    const box = await page.locator('#view-canvas').boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 150, box.y + box.height / 2 + 40, { steps: 5 });
    await page.mouse.up();
    const turned = await stage(page);
    assert(turned.differs(half) > 0.05, 'dragging turns');
    const seen = [turned];
    for (const look of ['side', 'front', 'top', 'iso']) {
      await page.click(`[data-look=${look}]`);
      const now = await stage(page);
      seen.forEach((other) => assert(now.differs(other) > 0.02, `${look} is a view of its own`));
      seen.push(now);
    }
    assert(seen.at(-1).differs(half) < 0.002, 'iso is where it began');
    await page.focus('#view-canvas');
    await page.keyboard.press('2');
    assert((await stage(page)).differs(seen[1]) < 0.002, 'key 2 looks from the side');
    await page.keyboard.press('.');
    assert.equal(await stamp(page), 0.55);
    isQuiet(page);
  },

  async 'colours, parts, cut and hole are what they say'(browser) {
    const page = await open(browser);
    await page.click('[data-look=front]');
    await page.click('h2:text("Bird and target")'); // elsewhere
    const far = await stage(page);
    const box = await page.locator('#view-canvas').boundingBox();
    await page.mouse.move(box.x + 100, box.y + 150);
    await page.mouse.wheel(0, -60);
    await page.waitForTimeout(300);
    assert((await stage(page)).differs(far) < 0.002, 'the wheel is the page\'s');
    await page.focus('#view-canvas');
    await page.mouse.wheel(0, -300);
    await page.waitForTimeout(300);
    assert((await stage(page)).differs(far) > 0.02, 'after a click it zooms');
    await page.click('[data-look=front]');
    const colours = await page.locator('.swatch').evaluateAll((all) => all.map((one) => getComputedStyle(one).backgroundColor.match(/\d+/g).map(Number)));
    const like = (wanted) => (r, g, b) => { // the hue of a lit sphere: the same ratios, darker
      const scale = (r + g + b) / (wanted[0] + wanted[1] + wanted[2]);
      return scale > 0.5 && Math.abs(r - scale * wanted[0]) + Math.abs(g - scale * wanted[1]) + Math.abs(b - scale * wanted[2]) < 30;
    };
    await page.selectOption('#target-colour', '');
    const both = await stage(page);
    colours.forEach((colour, k) => assert(both.count(like(colour)) > 50, `part ${k} is seen`));
    await page.locator('.parts input').first().uncheck();
    const one = await stage(page);
    assert.equal(one.count(like(colours[0])), 0, 'a hidden part is gone');
    await page.locator('.parts input').last().uncheck();

    // The sheet alone: whole at first, with a hole in the middle at the end.
    const middle = (pixels) => pixels.at(pixels.width / 2 + 4, pixels.height / 2 + 4);
    const paper = (await stage(page)).at(30, 300);
    assert.notDeepEqual(middle(await stage(page)), paper);
    await setTime(page, 1);
    assert.deepEqual(middle(await stage(page)), paper, 'eroded elements are hidden');
    const drawn = async () => (await stage(page)).count((r, g, b) => Math.abs(r - paper[0]) + Math.abs(g - paper[1]) + Math.abs(b - paper[2]) > 24);
    const whole = await drawn();
    await page.check('#cut');
    const cut = await drawn();
    assert(cut > 0.3 * whole && cut < 0.7 * whole, `cut open: ${cut} of ${whole} pixels`);
    await page.uncheck('#cut');
    await page.uncheck('#show-target');
    const rest = await drawn();
    assert(rest < 50, `nothing is left but ${rest} pixels`); // the corners of the frame
    await page.check('#show-target');

    const names = await page.locator('#target-colour option').evaluateAll((all) => all.map((one) => one.value));
    assert(['displacement', 'von_mises', 'plastic_strain', 'peak_contact_pressure'].every((name) => names.includes(name)), names.join());
    const plain = await stage(page);
    await page.selectOption('#target-colour', 'plastic_strain');
    assert((await stage(page)).differs(plain) > 0.05, 'a field colours the target');
    assert.match(await page.locator('#target-legend').textContent(), /plastic strain \[%\]/);
    const wide = await stage(page);
    const end = parseFloat((await page.locator('#target-legend .bar-ends span').last().textContent()).replace('≥', ''));
    await page.locator('#target-legend input').fill('0.1');
    assert((await stage(page)).differs(wide) > 0.005, 'a narrower range spreads the colours');
    const now = parseFloat((await page.locator('#target-legend .bar-ends span').last().textContent()).replace('≥', ''));
    assert(Math.abs(now / end - 0.1) < 0.002, `${now} is a tenth of ${end}`);
    isQuiet(page);
  },

  async 'dark, narrow and printed'(browser) {
    const dark = await open(browser, { colorScheme: 'dark' });
    const light = (pixels) => pixels.at(30, 300).reduce((a, b) => a + b) / 3;
    assert(light(await stage(dark)) < 60, 'the view is dark, too');
    await dark.click('#theme');
    assert(light(await stage(dark)) > 200, 'the button lights it');
    isQuiet(dark);

    const narrow = await open(browser, { viewport: { width: 400, height: 800 } });
    assert(await narrow.evaluate(() => document.documentElement.scrollWidth) <= 400, 'nothing sticks out');
    assert((await stage(narrow)).colours() > 8);
    isQuiet(narrow);

    const printed = await open(browser);
    const picture = () => printed.evaluate(() => document.getElementById('view-print').src);
    const before = await picture();
    await setTime(printed, 0.5);
    await printed.pdf({ format: 'A4' });
    assert((await picture()).length > 5000, 'the picture that is printed is not empty');
    assert.notEqual(await picture(), before, 'the moment that is seen is printed');
    isQuiet(printed);
  },

  async 'without WebGL there is a message and the pictures'() {
    const page = await open(await launch(['--disable-3d-apis']));
    assert.match(await page.locator('#view-message').textContent(), /no WebGL/);
    assert(await page.locator('#pictures img').first().isVisible());
    assert(!await page.locator('#play').isVisible());
    isQuiet(page);
  },
};

let failed = 0;
try {
  birdstrike('run', path.join(here, 'sheet.toml'), '-o', 'sheet', '--threads', '1', '--quiet');
  birdstrike('report', 'sheet', '-o', 'sheet.html');
  const browser = await launch(software);
  for (const [name, check] of Object.entries(checks)) {
    try {
      await check(browser);
      console.log(`ok    ${name}`);
    } catch (error) {
      ++failed;
      console.log(`FAIL  ${name}\n${error.stack}`);
    }
  }
} finally {
  await Promise.all(browsers.map((browser) => browser.close()));
  rmSync(folder, { recursive: true });
}
process.exitCode = failed ? 1 : 0;
