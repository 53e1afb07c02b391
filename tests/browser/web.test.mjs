// What belongs to the page around the app: its policy, plain words where it cannot run, use without a
// network, new versions, other pages that show it in a frame, the whole screen, a lost device.

import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { App, DEVICES } from './app.mjs';
import { launch } from './chromium.mjs';
import { serve } from './server.mjs';

const DIST = process.env.RIEMAP_DIST ?? fileURLToPath(new URL('../../dist', import.meta.url));

/** Runs in the page before its scripts: a browser without any graphics. */
function withoutGraphics() {
  HTMLCanvasElement.prototype.getContext = () => null;
  Object.defineProperty(Navigator.prototype, 'gpu', { value: undefined });
}

/** Runs in the page before its scripts: remembers the device, to lose it. */
function rememberDevice() {
  const { requestDevice } = GPUAdapter.prototype;
  GPUAdapter.prototype.requestDevice = async function (...given) {
    window.device = await requestDevice.apply(this, given);
    return window.device;
  };
}

/** Runs in the page before its scripts: notes how far the bar is whenever it moves. */
function noteProgress() {
  window.progress = [];
  const { set, get } = Object.getOwnPropertyDescriptor(HTMLProgressElement.prototype, 'value');
  Object.defineProperty(HTMLProgressElement.prototype, 'value', {
    get,
    set(value) {
      window.progress.push(value);
      set.call(this, value);
    },
  });
}

/** Gives the build in `folder` another version, as a change of the app would. */
function changeVersion(folder, version) {
  const old = readdirSync(folder).find((name) => name.startsWith('app-'));
  renameSync(join(folder, old), join(folder, version));
  for (const name of ['index.html', 'service-worker.js']) {
    const file = join(folder, name);
    writeFileSync(file, readFileSync(file, 'utf8').replaceAll(old, version));
  }
}

let site;
before(async () => (site = await serve(DIST, { packed: true, below: '/a/b/' })));
after(() => site?.close());

describe('the page, with WebGL2', () => {
  let browser;
  before(async () => (browser = await launch('WebGL2')));
  after(() => browser?.close());

  const withApp = (act, options = '') => async () => {
    const app = await App.open(browser, site.address + options, DEVICES.desktop);
    await app.during(() => act(app));
  };

  test(
    'the bar follows a compressed download to its end',
    async () => {
      const app = await App.open(browser, site.address, DEVICES.desktop, noteProgress);
      await app.during(async () => {
        const progress = await app.page.evaluate(() => window.progress);
        assert.ok(progress.length > 3, `${progress.length} steps`);
        assert.deepEqual(progress, [...progress].sort((a, b) => a - b), 'it never goes back');
        assert.equal(progress.at(-1), 1);
      });
    },
  );

  test(
    'the policy refuses a script that is no file of the app',
    async () => {
      const page = await browser.newPage();
      await page.goto(site.address);
      const refused = await page.evaluate(
        () =>
          new Promise((done) => {
            document.addEventListener('securitypolicyviolation', (event) => done(event.effectiveDirective));
            const script = document.createElement('script');
            script.textContent = 'window.injected = true';
            document.body.append(script);
          }),
      );
      assert.equal(refused, 'script-src-elem');
      assert.equal(await page.evaluate(() => window.injected), undefined);
      await page.close();
    },
  );

  for (const [locale, words] of [['en-GB', /neither of them/], ['de-AT', /keines von beiden/]]) {
    test(`without any graphics the page says what to do, in ${locale}, and fetches nothing large`, async () => {
      const context = await browser.newContext({ locale });
      const page = await context.newPage();
      await page.addInitScript(withoutGraphics);
      const asked = [];
      page.on('request', (request) => asked.push(request.url()));
      await page.goto(site.address);
      const text = await page.locator('#plain-words').innerText();
      assert.match(text, words);
      assert.equal(await page.locator('#plain-words li').count(), 3);
      assert.deepEqual(asked.filter((url) => url.endsWith('.wasm')), []);
      await context.close();
    });
  }

  test(
    'it can be installed: the manifest names pictures of the sizes that it says',
    withApp(async ({ page }) => {
      const address = await page.evaluate(() => document.querySelector('link[rel=manifest]').href);
      const manifest = await (await fetch(address)).json();
      assert.ok(manifest.icons.some(({ purpose }) => purpose === 'maskable'));
      for (const { src, sizes } of manifest.icons.filter(({ type }) => type === 'image/png')) {
        const png = Buffer.from(await (await fetch(new URL(src, address))).arrayBuffer());
        // a PNG begins with its signature and its width and height
        assert.equal(`${png.readUInt32BE(16)}x${png.readUInt32BE(20)}`, sizes, src);
      }
      assert.equal(new URL(manifest.start_url, address).href, site.address);
    }),
  );

  test('it opens again without a network', async () => {
    const host = await serve(DIST, { packed: true, below: '/maps/' });
    const app = await App.open(browser, host.address, DEVICES.desktop);
    await app.during(async () => {
      await app.page.waitForFunction(() => navigator.serviceWorker.controller !== null);
      await host.close();
      await app.reload();
      assert.equal((await app.session()).source.outline.preset, 'gingerbread');
    });
  });

  test('a new version waits until it is asked for, then takes over as a whole', async () => {
    const folder = mkdtempSync(join(tmpdir(), 'riemap-'));
    cpSync(DIST, folder, { recursive: true });
    const host = await serve(folder, { packed: true });
    const app = await App.open(browser, host.address, DEVICES.desktop);
    const version = () => app.page.evaluate(() => document.querySelector('script[type=module]').src);
    await app.during(async () => {
      const { page } = app;
      await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
      changeVersion(folder, 'app-0123456789abcdef');
      await page.evaluate(async () => (await navigator.serviceWorker.getRegistration()).update());
      await page.locator('#update').waitFor();
      await app.reload();
      assert.doesNotMatch(await version(), /0123456789abcdef/, 'the old version is whole until it is left');
      await page.locator('#update-reload').click();
      await page.waitForFunction(() => document.querySelector('script[type=module]')?.src.includes('0123456789abcdef'));
      await app.until('the new version shows a map', (stats) => stats.ready);
      const caches = await page.evaluate(async () => (await caches.keys()).length);
      assert.equal(caches, 1, 'the old version is gone');
    });
    await host.close();
    rmSync(folder, { recursive: true });
  });

  test(
    'in a frame there are the pictures alone, with the way to the whole app',
    withApp(async (app) => {
      const { handles } = await app.stats();
      // no panel to the left, no bar above: the source's picture begins at the window's corner
      assert.ok(handles.x1[0] < 0.5 * DEVICES.desktop.viewport.width - 200, `x₁ at ${handles.x1}`);
      await app.press('Tab');
      assert.deepEqual((await app.stats()).handles, handles, 'the panels stay away');
      const before = await app.address();
      await app.drag(handles.y1, [handles.y1[0] + 40, handles.y1[1] - 40]);
      await app.otherAddress(before);
      const link = new URL(await app.page.locator('#open-in-riemap').getAttribute('href'));
      assert.equal(link.search, '');
      assert.equal(link.hash, new URL(app.address()).hash);
    }, '?embed'),
  );

  test(
    'a locked dot stays where it is, the other one moves',
    withApp(async (app) => {
      const start = await app.session();
      const { handles } = await app.stats();
      await app.drag(handles.x1, [handles.x1[0] + 40, handles.x1[1] + 30]);
      await app.drag(handles.y1, [handles.y1[0] + 40, handles.y1[1] - 40]);
      await app.until('a dot has moved', (stats) => stats.ready && stats.undo > 0);
      const moved = await app.session();
      assert.deepEqual(moved.interior, start.interior);
      assert.notDeepEqual(moved.anchor, start.anchor);
    }, '?lock=interior,view'),
  );

  test(
    'a locked outline keeps files out and says so',
    withApp(async (app) => {
      const start = await app.session();
      await app.loadOutline('source', 'triangle.csv', '0,0\n3,0\n1,2\n');
      await app.until('the file is refused', (stats) => stats.errors.some((error) => /outline/.test(error)));
      assert.deepEqual(await app.session(), start);
    }, '?lock=outline'),
  );

  test(
    'a PNG that is dropped is decoded by the browser and becomes the texture',
    withApp(async ({ page }) => {
      await page.evaluate(async () => {
        const picture = new OffscreenCanvas(64, 48);
        picture.getContext('2d').fillRect(8, 8, 30, 20);
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([await picture.convertToBlob()], 'box.png'));
        const canvas = document.querySelector('canvas');
        for (const type of ['dragenter', 'dragover', 'drop']) {
          canvas.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, clientX: 400, clientY: 400, dataTransfer }));
        }
      });
      await page.waitForFunction(() => window.riemap.session().texture === 'image');
    }),
  );

  test(
    'a lock that there is not is reported',
    withApp(async (app) => {
      assert.match((await app.stats()).errors.join(), /lock=outlines/);
    }, '?lock=outlines'),
  );

  test('a page asks the app in its frame for the session and gives it another one', async () => {
    const page = await browser.newPage(DEVICES.desktop);
    const faults = [];
    page.on('pageerror', (error) => faults.push(String(error)));
    page.on('console', (message) => message.type() === 'error' && faults.push(message.text()));
    await page.goto(new URL('embedding.html', site.address).href);
    await page.locator('#heard').getByText('ready').or(page.locator('#heard').getByText('session-changed')).waitFor();
    const frame = page.frames().find((each) => each !== page.mainFrame());
    const ready = () => frame.waitForFunction(() => window.riemap?.stats?.()?.ready);
    await ready();
    await page.locator('#keep').click();
    await page.locator('#done').getByText('the map is kept').waitFor();
    const kept = await frame.evaluate(() => window.riemap.session());
    await frame.evaluate(() => window.riemap.open_session({ ...window.riemap.session(), texture_scale: 21 }));
    await page.locator('#heard').getByText('session-changed').waitFor();
    await page.locator('#back').click();
    await page.locator('#done').getByText('the map is back').waitFor();
    assert.deepEqual(await frame.evaluate(() => window.riemap.session()), kept);

    const answers = await page.evaluate(async () => {
      const target = document.getElementById('map').contentWindow;
      const ask = (message) =>
        new Promise((done) => {
          window.addEventListener('message', function heard({ data }) {
            if (data.id !== message.id) return;
            window.removeEventListener('message', heard);
            done(data);
          });
          target.postMessage(message, '*');
        });
      const set = (id, fields) => ask({ riemap: 1, type: 'set-session', id, ...fields });
      return {
        version: await ask({ riemap: 2, type: 'get-session', id: 'a' }),
        type: await ask({ riemap: 1, type: 'remove-everything', id: 'b' }),
        nothing: await set('c', {}),
        noSession: await set('d', { session: { version: 1 } }),
        far: await set('e', { session: { texture_scale: 1e300 } }),
        link: await set('f', { link: '#s=1.AAAAnonsense' }),
        good: await ask({ riemap: 1, type: 'get-session', id: 'g' }),
      };
    });
    const { good, ...bad } = answers;
    for (const [what, { ok, error }] of Object.entries(bad)) {
      assert.ok(ok === false && error.length > 10, `${what}: ${error}`);
    }
    assert.deepEqual([good.ok, good.session], [true, kept], 'the app goes on as before');
    const whole = await page.evaluate((link) => {
      const target = document.getElementById('map').contentWindow;
      return new Promise((done) => {
        window.addEventListener('message', ({ data }) => data.id === 'h' && done(data));
        target.postMessage({ riemap: 1, type: 'set-session', id: 'h', link }, '*');
      });
    }, good.link);
    assert.deepEqual(whole, { riemap: 1, id: 'h', ok: true });
    assert.deepEqual(faults, []);
    await page.close();
  });

  test(
    'a frame without options neither goes on with the kept session nor keeps one',
    withApp(async (app) => {
      await app.openSession({ texture_scale: 19 });
      await app.page.waitForFunction(() => JSON.parse(localStorage.getItem('riemap session'))?.texture_scale === 19);
      const kept = await app.page.evaluate(() => localStorage.getItem('riemap session'));
      // the example page lies beside the app: the two have one storage
      const around = await app.page.context().newPage();
      await around.goto(new URL('embedding.html', site.address).href);
      const [frame] = around.mainFrame().childFrames();
      await frame.goto(site.address);
      await frame.waitForFunction(() => window.riemap?.stats?.()?.ready);
      assert.equal(await frame.evaluate(() => window.riemap.session().texture_scale), 8);
      await frame.evaluate(() => window.riemap.open_session({ ...window.riemap.session(), texture_scale: 21 }));
      await frame.waitForFunction(() => window.riemap.stats().undo === 1 && location.hash === window.riemap.link());
      assert.equal(await around.evaluate(() => localStorage.getItem('riemap session')), kept);
      await around.close();
    }),
  );

  test(
    'the link is that of the present session, and null where none carries it',
    withApp(async (app) => {
      const [before, link, address] = await app.page.evaluate(() => {
        const before = window.riemap.link();
        window.riemap.open_session({ ...window.riemap.session(), texture_scale: 23 });
        return [before, window.riemap.link(), location.hash];
      });
      assert.match(link, /^#s=1\./);
      assert.ok(link !== before && link !== address, 'it does not wait for the address');
      await app.page.waitForFunction((hash) => location.hash === hash, link);
      await app.page.evaluate(() => {
        const rough = (k) => 1 + 0.01 * (((k * 2654435761) >>> 16) / 65536);
        const at = (k) => [rough(k) * Math.cos((k * Math.PI) / 3000), rough(k) * Math.sin((k * Math.PI) / 3000)];
        const outline = { points: { name: 'rough', points: Array.from({ length: 6000 }, (_, k) => at(k)) } };
        const session = window.riemap.session();
        window.riemap.open_session({ ...session, source: { ...session.source, outline } });
      });
      await app.until('the rough outline is mapped', (stats) => stats.ready);
      assert.equal((await app.session()).source.outline.points.name, 'rough');
      assert.equal(await app.page.evaluate(() => window.riemap.link()), null);
    }),
  );

  test(
    'F fills the screen and gives it back',
    withApp(async (app) => {
      await app.press('f');
      await app.page.waitForFunction(() => document.fullscreenElement !== null);
      await app.press('f');
      await app.page.waitForFunction(() => document.fullscreenElement === null);
    }),
  );

  test(
    'at presentation size dots are where they are drawn',
    withApp(async (app) => {
      const start = await app.session();
      const { handles } = await app.stats();
      const [x, y] = handles.x1;
      assert.ok((await app.picture('presentation')).length > 50);
      await app.drag([x, y], [x + 30, y - 30], 8);
      await app.until('the dot has moved', (stats) => stats.ready && stats.undo === 1);
      assert.notDeepEqual((await app.session()).interior, start.interior);
    }, '?present'),
  );

  test('after the graphics are lost the page says so, and a reload brings the map back', async () => {
    const app = await App.open(browser, site.address, DEVICES.desktop);
    await app.during(async () => {
      const before = await app.otherAddress(site.address);
      await app.openSession({ texture_scale: 19 });
      await app.otherAddress(before);
      const session = await app.session();
      await app.page.evaluate(() => document.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext());
      await app.page.locator('#failure').getByText('The map is kept').waitFor();
      await app.page.locator('#failure-reload').click();
      await app.until('the map is there again', (stats) => stats.ready);
      assert.deepEqual(await app.session(), session);
    });
  });
});

describe('the page, with WebGPU', () => {
  let browser;
  before(async () => (browser = await launch('WebGPU')));
  after(() => browser?.close());

  test('a lost device is told of', async () => {
    const app = await App.open(browser, site.address, DEVICES.desktop, rememberDevice);
    await app.during(async () => {
      assert.equal((await app.stats()).backend, 'WebGPU');
      await app.page.evaluate(() => window.device.destroy());
      await app.page.locator('#failure').getByText('The map is kept').waitFor();
    });
  });
});
