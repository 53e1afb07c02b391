// Nothing is lost: files with everything, a reload, back and forward, a browser without a database.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** A square of n × n cells, bent into a wave, as OBJ. */
function wave(n) {
  const lines = [];
  for (let j = 0; j <= n; j++) {
    for (let i = 0; i <= n; i++) lines.push(`v ${i / n} ${j / n} ${0.2 * Math.sin((6 * i) / n)}`);
  }
  const vertex = (i, j) => 1 + j * (n + 1) + i;
  for (let j = 0; j < n; j++) {
    for (let i = 0; i < n; i++) lines.push(`f ${vertex(i, j)} ${vertex(i + 1, j)} ${vertex(i + 1, j + 1)} ${vertex(i, j + 1)}`);
  }
  return Buffer.from(`${lines.join('\n')}\n`);
}

/** Runs in the page: drops a picture on the source. */
async function dropPicture() {
  const picture = new OffscreenCanvas(64, 48);
  const context = picture.getContext('2d');
  context.fillStyle = 'rgb(200, 40, 160)';
  context.fillRect(8, 8, 30, 20);
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([await picture.convertToBlob()], 'own.png'));
  const canvas = document.querySelector('canvas');
  for (const type of ['dragenter', 'dragover', 'drop']) {
    canvas.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, clientX: 500, clientY: 400, dataTransfer }));
  }
}

/** Runs in the page: the paths of the parts that are kept of the session in the address, or null. */
async function keptParts() {
  const asked = (request) => new Promise((done, failed) => {
    request.onsuccess = () => done(request.result);
    request.onerror = () => failed(request.error);
  });
  const database = await asked(indexedDB.open('riemap', 1));
  try {
    const visits = await asked(database.transaction('visits').objectStore('visits').getAll());
    const visit = visits.find(({ id, link }) => id === history.state?.riemap && `#${link}` === location.hash);
    return visit ? visit.parts.map(({ path }) => path) : null;
  } finally {
    database.close();
  }
}

/** Waits until the session in the address is kept with these parts. */
async function untilKept(app, ...needed) {
  for (;;) {
    const parts = await app.page.evaluate(keptParts);
    if (parts && needed.every((path) => parts.includes(path))) return parts;
    await app.page.waitForTimeout(50); // the database tells nobody when it changes
  }
}

/** Shows a surface with an own picture as the texture, after one more step. */
async function withEverything(app) {
  await app.openSession({ texture_scale: 17 });
  await app.until('a step', (stats) => stats.ready && stats.undo === 1);
  await app.loadFile('target', 'wave.obj', wave(12));
  await app.atRest('the surface is mapped', (stats) => stats.ready && stats.surface_ms !== null);
  await app.page.evaluate(dropPicture);
  return app.atRest('the picture is the texture', (stats) => stats.ready && stats.image === 'own.png');
}

/** Runs in the page before its scripts: there is no database. */
function withoutDatabase() {
  Object.defineProperty(window, 'indexedDB', { value: undefined });
}

/** Runs in the page before its scripts: the database has no room for more than 20 kB at once. */
function withLittleRoom() {
  const { put } = IDBObjectStore.prototype;
  IDBObjectStore.prototype.put = function (value, ...key) {
    if (value.byteLength > 20_000) throw new DOMException('no room', 'QuotaExceededError');
    return put.call(this, value, ...key);
  };
}

withOneBackend('kept', (bench) => {
  test(
    'a reload brings back the surface, the own picture and the undo steps',
    bench.withApp(async (app) => {
      const { undo, target, triangles } = await withEverything(app);
      const session = await app.session();
      assert.equal(session.texture, 'image');
      const parts = await untilKept(app, 'surfaces/wave.obj', 'picture/own.png', 'history.json');
      assert.ok(parts.includes('contents.json'));
      await app.shot('kept-before');
      await app.page.reload();
      const again = await app.atRest('all is shown again', (stats) => stats.ready && stats.image === 'own.png' && stats.surface_ms !== null);
      assert.deepEqual(again.errors, []);
      assert.deepEqual([again.undo, again.target, again.triangles], [undo, target, triangles]);
      assert.deepEqual(await app.session(), session);
      await app.shot('kept-after');
      for (let left = undo; left > 0; left--) {
        await app.press('Control+z');
        await app.until('a step back', (stats, steps) => stats.ready && stats.undo === steps, left - 1);
      }
      const first = await app.session();
      assert.deepEqual([first.texture, first.surface ?? null], ['checker', null]);
      await app.press('Control+Shift+z');
      await app.until('a step forward', (stats) => stats.ready && stats.undo === 1);
      assert.equal((await app.session()).texture_scale, 17);
    }),
  );

  test(
    'a file holds the surface, the own picture and the undo steps',
    bench.withApp(async (app) => {
      const { undo } = await withEverything(app);
      const session = await app.session();
      const { name, bytes } = await app.downloadBy('Control+s');
      assert.equal(name, 'map.riemap');
      assert.equal(bytes.subarray(0, 4).toString('latin1'), 'PK\u0003\u0004');
      const other = await bench.open(bench.address());
      await other.during(async () => {
        await other.loadFile('source', name, bytes.subarray(0, bytes.length - 30));
        const { errors } = await other.until('a cut file is refused', (stats) => stats.errors.length > 0);
        assert.match(errors.join(' '), /map\.riemap.*damaged/);
        await other.loadFile('source', name, bytes);
        const opened = await other.atRest('the file is opened', (stats) => stats.ready && stats.image === 'own.png' && stats.surface_ms !== null);
        assert.deepEqual(opened.errors, []);
        assert.ok(opened.undo >= undo, `${opened.undo} steps of ${undo}`);
        assert.deepEqual(await other.session(), session);
        await other.shot('kept-file');
      });
    }),
  );

  test(
    'back and forward step through opened sessions, each with its undo steps',
    bench.withApp(async (app) => {
      await app.openSession({ texture_scale: 11 });
      const own = await app.until('own work', (stats) => stats.ready && stats.undo === 1);
      const mine = await app.session();
      const first = await app.otherAddress(bench.address());
      const other = { ...mine, texture: 'grid', texture_scale: 23 };
      const bytes = Buffer.from(JSON.stringify({ ...other, riemap: other.version }));
      await app.loadFile('source', 'other.riemap', bytes);
      await app.until('the file is opened', (stats) => stats.ready && stats.undo === 2);
      await app.otherAddress(first);
      assert.equal((await app.session()).texture, 'grid');
      await app.page.goBack();
      await app.until('own work again', (stats, undo) => stats.ready && stats.undo === undo, own.undo);
      assert.deepEqual(await app.session(), mine);
      await app.press('Control+z');
      await app.until('with its steps', (stats) => stats.ready && stats.undo === 0);
      await app.page.goForward();
      await app.until('the file again', (stats) => stats.ready && stats.undo === 2);
      assert.equal((await app.session()).texture, 'grid');
      await app.page.goBack();
      await app.until('as it was left', (stats) => stats.ready && stats.undo === 0);
    }),
  );

  test(
    'an entry of the gallery is an entry of the history: back returns to own work',
    bench.withApp(async (app) => {
      await app.openSession({ texture_scale: 11 });
      await app.until('own work', (stats) => stats.ready && stats.undo === 1);
      const mine = await app.session();
      await app.otherAddress(bench.address());
      await app.walkTo(/^Gallery, button/);
      await app.press('Space');
      await app.walkTo(/^Square the circle: /);
      await app.press('Enter');
      const square = () => window.riemap.session().source.outline.preset === 'square';
      await app.until('the square over the disk', (stats) => stats.ready && stats.undo === 2);
      assert.ok(await app.page.evaluate(square));
      await app.page.goBack();
      await app.until('own work again', (stats) => stats.ready && stats.undo === 1);
      assert.deepEqual(await app.session(), mine);
      await app.page.goForward();
      await app.until('the square again', (stats) => stats.ready && stats.undo === 2);
      assert.ok(await app.page.evaluate(square));
    }),
  );

  test(
    'a link of another person overwrites no own work, and back returns to it over a reload',
    bench.withApp(async (app) => {
      const start = await app.otherAddress(bench.address());
      await app.openSession({ texture_scale: 11 });
      await app.until('own work', (stats) => stats.ready && stats.undo === 1);
      await app.otherAddress(start);
      await untilKept(app, 'history.json');
      const mine = await app.session();
      await app.paste(new URL(start).hash);
      await app.until('the link is opened', (stats) => stats.ready && stats.undo === 2);
      await app.openSession({ texture_scale: 29 });
      await app.until('it is changed', (stats) => stats.ready && stats.undo === 3);
      await app.otherAddress(start);
      await untilKept(app, 'history.json');
      await app.reload();
      assert.equal((await app.session()).texture_scale, 29);
      await app.page.goBack();
      await app.until('own work again', (stats) => stats.ready && stats.undo === 1);
      assert.deepEqual(await app.session(), mine);
    }),
  );

  test(
    'a duplicated tab goes on with a copy, and neither tab overwrites the other',
    bench.withApp(async (app) => {
      const change = async (tab, scale, undo) => {
        const before = tab.address();
        await tab.openSession({ texture_scale: scale });
        await tab.until('a step', (stats, steps) => stats.ready && stats.undo === steps, undo);
        await tab.otherAddress(before);
        await untilKept(tab, 'history.json');
      };
      const visitOf = (tab) => tab.page.evaluate(() => history.state.riemap);
      await app.otherAddress(bench.address());
      await change(app, 11, 1);
      const twin = await app.duplicate();
      const { undo } = await twin.atRest('the same is shown');
      assert.deepEqual([undo, await twin.session()], [1, await app.session()], 'with its undo steps');
      assert.notEqual(await visitOf(twin), await visitOf(app));
      await twin.reload();
      assert.equal((await twin.stats()).undo, 1, 'the copy is kept at once');
      await change(twin, 29, 2);
      await change(app, 17, 2);
      for (const [tab, scale] of [[twin, 29], [app, 17]]) {
        const visit = await visitOf(tab);
        const again = await tab.reload();
        assert.deepEqual([again.undo, (await tab.session()).texture_scale], [2, scale]);
        assert.equal(await visitOf(tab), visit, 'a reload goes on with the same');
      }
    }),
  );

  test(
    'without a database the session alone is kept, which is said once',
    bench.withApp(
      async (app) => {
        await app.openSession({ texture_scale: 17 });
        const { errors } = await app.until('it is said', (stats) => stats.ready && stats.errors.length > 0);
        assert.match(errors.join(' '), /not its surfaces, pictures and undo steps/);
        await app.shot('kept-private');
        await app.reload();
        assert.equal((await app.session()).texture_scale, 17);
      },
      { prepare: withoutDatabase },
    ),
  );

  test(
    'what does not fit is left out, which is said once, and the rest is kept',
    bench.withApp(
      async (app) => {
        await app.openSession({ texture_scale: 17 });
        await app.until('a step', (stats) => stats.ready && stats.undo === 1);
        await app.loadFile('target', 'wave.obj', wave(40));
        const { errors, undo } = await app.until('it is said', (stats) => stats.ready && stats.surface_ms && stats.errors.length > 0);
        assert.match(errors.join(' '), /without its surfaces and pictures/);
        const parts = await untilKept(app, 'history.json');
        assert.ok(!parts.includes('surfaces/wave.obj'));
        await app.page.reload();
        const again = await app.until('the file is asked for', (stats) => stats.errors.some((text) => text.includes('wave.obj')));
        assert.ok(again.undo <= undo);
      },
      { prepare: withLittleRoom },
    ),
  );
});
