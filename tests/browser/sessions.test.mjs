// Persistence of sessions: undo, the address, a reload, a file.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** A triangle that differs from all presets. */
const TRIANGLE = '0,0\n3,0\n1,2\n';

withOneBackend('sessions', (bench) => {
  test(
    'a drag is one step back and one forward',
    bench.withApp(async (app) => {
      const start = await app.session();
      const { handles } = await app.stats();
      await app.drag(handles.x1, [handles.x1[0] + 25, handles.x1[1] - 30]);
      await app.until('the map has come to rest', (stats) => stats.ready && stats.undo === 1);
      const dragged = await app.session();
      assert.notDeepEqual(dragged.interior, start.interior);
      await app.press('Control+z');
      await app.until('the step is taken back', (stats) => stats.ready && stats.undo === 0);
      assert.deepEqual(await app.session(), start);
      await app.press('Control+Shift+z');
      await app.until('the step is made again', (stats) => stats.ready && stats.undo === 1);
      assert.deepEqual(await app.session(), dragged);
    }),
  );

  test(
    'the address opens the same picture in another window',
    bench.withApp(async (app) => {
      const before = await app.otherAddress(bench.address());
      await app.openSession({ texture: 'grid', texture_scale: 13, direction: 'backward', anchor: [0.25, 0.5], wireframe: true });
      const address = await app.otherAddress(before);
      assert.match(address, /#s=1\./);
      const [session, stats] = [await app.session(), await app.atRest('the map is refined')];
      const other = await bench.open(address);
      await other.during(async () => {
        assert.deepEqual(await other.session(), session);
        const opened = await other.stats();
        assert.deepEqual(opened.errors, []);
        const difference = Math.abs(opened.boundary_checksum - stats.boundary_checksum);
        assert.ok(difference < 1e-9 * Math.abs(stats.boundary_checksum), `the same map: ${difference}`);
      });
    }),
  );

  test(
    'a link that is pasted into the address is opened, and can be taken back',
    bench.withApp(async (app) => {
      const start = await app.session();
      const first = await app.otherAddress(bench.address());
      await app.openSession({ texture_scale: 16 });
      await app.otherAddress(first);
      await app.paste(new URL(first).hash);
      await app.until('the link is opened', (stats) => stats.ready && stats.undo === 2);
      assert.deepEqual(await app.session(), start);
    }),
  );

  test(
    'a damaged link gives a message and the default session',
    bench.withApp(async (app) => {
      const { errors } = await app.stats();
      assert.match(errors.join(' '), /link could not be opened/);
      assert.equal((await app.session()).source.outline.preset, 'gingerbread');
    }, { at: '#s=1.AAAAnonsense' }),
  );

  test(
    'a reload brings everything back, a loaded outline too',
    bench.withApp(async (app) => {
      const first = await app.otherAddress(bench.address());
      await app.loadOutline('source', 'triangle.csv', TRIANGLE);
      await app.otherAddress(first);
      const session = await app.session();
      assert.equal(session.source.outline.points.name, 'triangle');
      await app.reload();
      assert.deepEqual(await app.session(), session);
    }),
  );

  test(
    'a session is saved as a file and opened again',
    bench.withApp(async (app) => {
      const first = await app.otherAddress(bench.address());
      await app.openSession({ texture_scale: 17 });
      const second = await app.otherAddress(first);
      const saved = await app.session();
      const { name, bytes } = await app.downloadBy('Control+s');
      assert.equal(name, 'map.riemap');
      await app.openSession({ texture_scale: 5 });
      await app.otherAddress(second);
      await app.loadFile('source', name, bytes);
      await app.until('the file is opened with its steps', (stats) => stats.ready && stats.undo === 4);
      assert.deepEqual(await app.session(), saved);
    }),
  );
});
