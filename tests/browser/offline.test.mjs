// Offline use and updates: the service worker stores exactly one complete build at a time.

import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { DIST, withOneBackend } from './backends.mjs';
import { serve } from './server.mjs';

/** Changes the version of the build in `folder`, as a change of the app would. */
function changeVersion(folder, version) {
  const old = readdirSync(folder).find((name) => name.startsWith('app-'));
  renameSync(join(folder, old), join(folder, version));
  for (const name of ['index.html', 'service-worker.js']) {
    const file = join(folder, name);
    writeFileSync(file, readFileSync(file, 'utf8').replaceAll(old, version));
  }
}

/** Waits until the service worker controls the page; it has then stored everything. */
const isKept = (page) => page.waitForFunction(() => navigator.serviceWorker.controller !== null);

withOneBackend('kept for use without a network', (bench) => {
  test('it opens again without a network', async (context) => {
    const host = await serve(DIST, { packed: true, below: '/maps/' });
    context.after(() => host.close()); // closing twice is allowed
    const app = await bench.open(host.address);
    await app.during(async () => {
      await isKept(app.page);
      await host.close();
      await app.reload();
      assert.equal((await app.session()).source.outline.preset, 'gingerbread');
    });
  });

  test('a new version waits until it is asked for, then takes over as a whole', async (context) => {
    const folder = mkdtempSync(join(tmpdir(), 'riemap-'));
    cpSync(DIST, folder, { recursive: true });
    const host = await serve(folder, { packed: true });
    context.after(async () => {
      await host.close();
      rmSync(folder, { recursive: true });
    });
    const app = await bench.open(host.address);
    const { page } = app;
    const version = () => page.evaluate(() => document.querySelector('script[type=module]').src);
    await app.during(async () => {
      await isKept(page);
      changeVersion(folder, 'app-0123456789abcdef');
      await page.evaluate(async () => (await navigator.serviceWorker.getRegistration()).update());
      await page.locator('#update').waitFor();
      await app.reload();
      assert.doesNotMatch(await version(), /0123456789abcdef/, 'the old version is whole until it is left');
      await page.locator('#update-reload').click();
      await page.waitForFunction(() => document.querySelector('script[type=module]')?.src.includes('0123456789abcdef'));
      await app.atRest('the new version shows a map');
      const caches = await page.evaluate(async () => (await caches.keys()).length);
      assert.equal(caches, 1, 'the old version is gone');
    });
  });
});
