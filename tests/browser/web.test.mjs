// The page around the app: download progress, content security policy, messages where the app cannot
// run, images decoded by the browser, full screen, loss of the graphics device.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { DIST, withEachBackend, withOneBackend } from './backends.mjs';
import { serve } from './server.mjs';

/** Runs in the page before its scripts: disables all graphics. */
function withoutGraphics() {
  HTMLCanvasElement.prototype.getContext = () => null;
  Object.defineProperty(Navigator.prototype, 'gpu', { value: undefined });
}

/** What older browsers lack, each removed in the page before its scripts. */
const LACKS = {
  streams: () => { delete window.TransformStream; },
  // such a browser does not ask for the type of a worker
  'workers that are modules': () => { window.Worker = class { terminate() {} }; },
};

/** Runs in the page before its scripts: stores the device, so that a test can destroy it. */
function rememberDevice() {
  const { requestDevice } = GPUAdapter.prototype;
  GPUAdapter.prototype.requestDevice = async function (...given) {
    window.device = await requestDevice.apply(this, given);
    return window.device;
  };
}

/** How the graphics are lost: `prepare` runs in the page before its scripts, `lose` later. */
const LOSSES = {
  WebGPU: { prepare: rememberDevice, lose: () => window.device.destroy() },
  WebGL2: {
    lose: () => document.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext(),
  },
};

/** Runs in the page before its scripts: records every value of the progress bar. */
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

/** Runs in the page: adds an inline script, and returns the violated policy directive. */
function addScript() {
  return new Promise((done) => {
    document.addEventListener('securitypolicyviolation', (event) => done(event.effectiveDirective));
    const script = document.createElement('script');
    script.textContent = 'window.injected = true';
    document.body.append(script);
  });
}

/** Runs in the page: drops a picture on it. */
async function dropPicture() {
  const picture = new OffscreenCanvas(64, 48);
  picture.getContext('2d').fillRect(8, 8, 30, 20);
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([await picture.convertToBlob()], 'box.png'));
  const canvas = document.querySelector('canvas');
  for (const type of ['dragenter', 'dragover', 'drop']) {
    canvas.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, clientX: 400, clientY: 400, dataTransfer }));
  }
}

withOneBackend(
  'the page',
  (bench) => {
    test('the bar follows a compressed download to its end', async (context) => {
      let goOn;
      const half = new Promise((resolve) => (goOn = resolve));
      const isProgram = (file) => file.endsWith('.wasm.packed');
      const host = await serve(DIST, { packed: true, halfway: (file) => isProgram(file) && half });
      context.after(() => {
        goOn();
        return host.close();
      });
      const app = await bench.open(host.address, { prepare: noteProgress });
      await app.page.waitForFunction(() => Math.abs(document.getElementById('loading-bar').value - 0.5) < 0.1);
      goOn();
      await app.during(async () => {
        const progress = await app.page.evaluate(() => window.progress);
        assert.deepEqual(progress, [...progress].sort((a, b) => a - b), 'it never goes back');
        assert.equal(progress.at(-1), 1);
      });
    });

    for (const colorScheme of ['dark', 'light']) {
      test(
        `while it loads the page has the color that it declares for a ${colorScheme} theme`,
        bench.withPage(async (page) => {
          await page.route('**/*.wasm*', () => {}); // is never answered
          await page.goto(bench.address(), { waitUntil: 'commit' });
          const loading = page.locator('#loading');
          await loading.waitFor({ state: 'visible' });
          const ground = await loading.evaluate((element) => getComputedStyle(element).backgroundColor);
          const declared = await page.locator(`meta[name=theme-color][media*=${colorScheme}]`).getAttribute('content');
          assert.deepEqual(ground.match(/\d+/g).map(Number), declared.match(/[0-9a-f]{2}/g).map((hex) => parseInt(hex, 16)));
        }, { colorScheme }),
      );
    }

    test(
      'the policy refuses a script that is no file of the app',
      bench.withPage(
        async (page) => {
          await page.goto(bench.address());
          assert.equal(await page.evaluate(addScript), 'script-src-elem');
          assert.equal(await page.evaluate(() => window.injected), undefined);
        },
        { expected: /inline script|Content Security Policy/i },
      ),
    );

    for (const [locale, words] of [['en-GB', /neither of them/], ['de-AT', /keines von beiden/]]) {
      test(
        `without any graphics the page says what to do, in ${locale}, and fetches nothing large`,
        bench.withPage(
          async (page) => {
            await page.addInitScript(withoutGraphics);
            const asked = [];
            page.on('request', (request) => asked.push(request.url()));
            await page.goto(bench.address());
            assert.match(await page.locator('#plain-words').innerText(), words);
            assert.equal(await page.locator('#plain-words li').count(), 3);
            assert.deepEqual(asked.filter((url) => url.includes('.wasm')), []);
          },
          { locale },
        ),
      );
    }

    for (const [lack, remove] of Object.entries(LACKS)) {
      test(
        `without ${lack} the page says what to do, and fetches nothing large`,
        bench.withPage(async (page) => {
          await page.addInitScript(remove);
          const asked = [];
          page.on('request', (request) => asked.push(request.url()));
          await page.goto(bench.address());
          assert.match(await page.locator('#plain-words').innerText(), /bring the browser up to date/i);
          assert.deepEqual(asked.filter((url) => url.includes('.wasm')), []);
        }, { locale: 'en-GB' }),
      );
    }

    test(
      'it can be installed: the manifest names pictures of the sizes that it says',
      bench.withPage(async (page) => {
        await page.goto(bench.address());
        const address = await page.evaluate(() => document.querySelector('link[rel=manifest]').href);
        const manifest = await (await fetch(address)).json();
        assert.ok(manifest.icons.some(({ purpose }) => purpose === 'maskable'));
        for (const { src, sizes } of manifest.icons.filter(({ type }) => type === 'image/png')) {
          const png = Buffer.from(await (await fetch(new URL(src, address))).arrayBuffer());
          // a PNG begins with its signature, then the header with width and height
          assert.equal(`${png.readUInt32BE(16)}x${png.readUInt32BE(20)}`, sizes, src);
        }
        assert.equal(new URL(manifest.start_url, address).href, bench.address());
      }),
    );

    test(
      'a PNG that is dropped is decoded by the browser and becomes the texture',
      bench.withApp(async ({ page }) => {
        await page.evaluate(dropPicture);
        await page.waitForFunction(() => window.riemap.session().texture === 'image');
      }),
    );

    test(
      'F fills the screen and gives it back',
      bench.withApp(async (app) => {
        await app.press('f');
        await app.page.waitForFunction(() => document.fullscreenElement !== null);
        await app.press('f');
        await app.page.waitForFunction(() => document.fullscreenElement === null);
      }),
    );

    test(
      'at presentation size dots are where they are drawn',
      bench.withApp(
        async (app) => {
          const start = await app.session();
          const { handles } = await app.stats();
          const [x, y] = handles.x1;
          assert.ok((await app.picture(`${bench.backend}-presentation`)).length > 50);
          await app.drag([x, y], [x + 30, y - 30]);
          await app.until('the dot has moved', (stats) => stats.ready && stats.undo === 1);
          assert.notDeepEqual((await app.session()).interior, start.interior);
        },
        { at: '?present' },
      ),
    );
  },
  { packed: true, below: '/a/b/' },
);

withEachBackend(
  'lost graphics',
  (bench) => {
    const { prepare, lose } = LOSSES[bench.backend];
    test(
      'after the graphics are lost they are rebuilt at once, undo included',
      bench.withApp(
        async (app) => {
          const before = await app.otherAddress(bench.address());
          await app.openSession({ texture_scale: 19 });
          await app.otherAddress(before);
          const [session, seen] = [await app.session(), await app.picture(`${bench.backend}-before-loss`)];
          for (let loss = 0; loss < 2; loss++) {
            const canvas = await app.page.evaluateHandle(() => document.querySelector('canvas'));
            await app.page.evaluate(lose);
            await app.page.waitForFunction((old) => document.querySelector('canvas') !== old, canvas);
            const { undo } = await app.atRest('the map is there again');
            assert.equal(undo, 1);
            assert.deepEqual(await app.session(), session);
          }
          const again = await app.picture(`${bench.backend}-after-loss`);
          assert.ok(again.length > 0.7 * seen.length, `${again.length} colours of ${seen.length}`);
          const { handles, generation } = await app.stats();
          await app.drag(handles.x1, [handles.x1[0] + 25, handles.x1[1] - 30]);
          await app.until('the map follows', (stats, last) => stats.ready && stats.generation > last, generation);
          await app.press('Control+z');
          await app.press('Control+z');
          await app.until('undo goes back before the loss', (stats) => stats.ready && stats.undo === 0);
        },
        { prepare },
      ),
    );

    test(
      'graphics that are lost again and again end with a message, and a reload brings the map back',
      bench.withApp(
        async (app) => {
          const before = await app.otherAddress(bench.address());
          await app.openSession({ texture_scale: 19 });
          await app.otherAddress(before);
          const session = await app.session();
          for (let loss = 0; loss < 3; loss++) {
            const canvas = await app.page.evaluateHandle(() => document.querySelector('canvas'));
            await app.page.evaluate(lose);
            await app.page.waitForFunction((old) => document.querySelector('canvas') !== old, canvas);
            await app.atRest('the map is there again');
          }
          await app.page.evaluate(lose);
          await app.page.locator('#failure', { hasText: 'The map is kept' }).waitFor();
          await app.page.locator('#failure-reload').click();
          await app.atRest('the map is there again');
          assert.deepEqual(await app.session(), session);
        },
        { prepare },
      ),
    );
  },
  { packed: true, below: '/a/b/' },
);
