// The app in a frame of another page: only its pictures, its locks, the messages between the two.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { DEVICES } from './app.mjs';
import { withOneBackend } from './backends.mjs';

/** Runs in the page before its scripts: records all messages. */
function noteMessages() {
  window.messages = [];
  window.addEventListener('message', ({ data }) => window.messages.push(data));
}

/** Runs in the page: the answers of the embedded app to invalid requests, and to a valid one. */
async function askForTooMuch() {
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
}

/** Runs in the page: the answer of the embedded app to a link. */
function giveLink(link) {
  const target = document.getElementById('map').contentWindow;
  return new Promise((done) => {
    window.addEventListener('message', ({ data }) => data.id === 'h' && done(data));
    target.postMessage({ riemap: 1, type: 'set-session', id: 'h', link }, '*');
  });
}

withOneBackend(
  'in a frame',
  (bench) => {
    test(
      'there are the pictures alone, with the way to the whole app',
      bench.withApp(
        async (app) => {
          const before = await app.otherAddress(bench.address('?embed'));
          const { handles } = await app.stats();
          // there is no panel on the left and no bar on top: the source's picture begins at the window's corner
          assert.ok(handles.x1[0] < 0.5 * DEVICES.desktop.viewport.width - 200, `x₁ at ${handles.x1}`);
          // after the pointer was used, Tab would fold or unfold the panels
          await app.pointAt([handles.x1[0] + 90, handles.x1[1] + 90]);
          await app.press('Tab');
          assert.deepEqual((await app.atRest()).handles, handles, 'the panels stay away');
          await app.drag(handles.y1, [handles.y1[0] + 40, handles.y1[1] - 40]);
          await app.otherAddress(before);
          const [address, link] = await app.page.evaluate(() => [location.href, document.getElementById('open-in-riemap').href]);
          assert.equal(new URL(link).search, '');
          assert.equal(new URL(link).hash, new URL(address).hash);
        },
        { at: '?embed' },
      ),
    );

    test(
      'a locked dot stays where it is, the other one moves',
      bench.withApp(
        async (app) => {
          const start = await app.session();
          const { handles } = await app.stats();
          await app.drag(handles.x1, [handles.x1[0] + 40, handles.x1[1] + 30]);
          await app.drag(handles.y1, [handles.y1[0] + 40, handles.y1[1] - 40]);
          await app.until('a dot has moved', (stats) => stats.ready && stats.undo > 0);
          const moved = await app.session();
          assert.deepEqual(moved.interior, start.interior);
          assert.notDeepEqual(moved.anchor, start.anchor);
        },
        { at: '?lock=interior,view' },
      ),
    );

    test(
      'a locked outline keeps files out and says so',
      bench.withApp(
        async (app) => {
          const start = await app.session();
          await app.loadOutline('source', 'triangle.csv', '0,0\n3,0\n1,2\n');
          await app.until('the file is refused', (stats) => stats.errors.some((error) => /outline/.test(error)));
          assert.deepEqual(await app.session(), start);
        },
        { at: '?lock=outline' },
      ),
    );

    test(
      'a lock that there is not is reported',
      bench.withApp(
        async (app) => {
          assert.match((await app.stats()).errors.join(), /lock=outlines/);
        },
        { at: '?lock=outlines' },
      ),
    );

    test(
      'the page around asks for the session and gives another one',
      bench.withPage(async (page) => {
        await page.addInitScript(noteMessages);
        await page.goto(bench.address('embedding.html'));
        const frame = page.frames().find((each) => each !== page.mainFrame());
        await page.waitForFunction(() => window.messages.some(({ type }) => type === 'ready'));
        await page.locator('#heard', { hasText: /ready|session-changed/ }).waitFor();
        await frame.waitForFunction(() => window.riemap?.stats?.()?.ready);
        assert.equal(await frame.evaluate(() => window.riemap.stats().backend), bench.backend);

        await page.locator('#keep').click();
        await page.locator('#done', { hasText: 'the map is kept' }).waitFor();
        const kept = await frame.evaluate(() => window.riemap.session());
        await frame.evaluate(() => window.riemap.open_session({ ...window.riemap.session(), texture_scale: 21 }));
        const isTold = ({ type, session }) => type === 'session-changed' && session.texture_scale === 21;
        await page.waitForFunction(new Function(`return window.messages.some(${isTold})`));
        await page.locator('#back').click();
        await page.locator('#done', { hasText: 'the map is back' }).waitFor();
        assert.deepEqual(await frame.evaluate(() => window.riemap.session()), kept);

        const { good, ...bad } = await page.evaluate(askForTooMuch);
        for (const [what, { ok, error }] of Object.entries(bad)) {
          assert.ok(ok === false && error.length > 10, `${what}: ${error}`);
        }
        assert.deepEqual([good.ok, good.session], [true, kept], 'the app goes on as before');
        assert.deepEqual(await page.evaluate(giveLink, good.link), { riemap: 1, id: 'h', ok: true });
      }, DEVICES.desktop),
    );

    test(
      'a frame without options neither goes on with the kept session nor keeps one',
      bench.withApp(async (app) => {
        await app.openSession({ texture_scale: 19 });
        await app.page.waitForFunction(() => JSON.parse(localStorage.getItem('riemap session'))?.texture_scale === 19);
        const kept = await app.page.evaluate(() => localStorage.getItem('riemap session'));
        // the example page has the same origin as the app, and therefore the same storage
        const around = await app.page.context().newPage();
        await around.goto(bench.address('embedding.html'));
        const [frame] = around.mainFrame().childFrames();
        await frame.goto(bench.address(''));
        await frame.waitForFunction(() => window.riemap?.stats?.()?.ready);
        assert.equal(await frame.evaluate(() => window.riemap.session().texture_scale), 20);
        await frame.evaluate(() => window.riemap.open_session({ ...window.riemap.session(), texture_scale: 21 }));
        await frame.waitForFunction(() => window.riemap.stats().undo === 1 && location.hash === window.riemap.link());
        assert.equal(await around.evaluate(() => localStorage.getItem('riemap session')), kept);
        await around.close();
      }),
    );

    test(
      'the link is that of the present session, and null where none carries it',
      bench.withApp(async (app) => {
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
        await app.page.waitForFunction(() => window.riemap.session().source.outline.points?.name === 'rough');
        const long = await app.page.evaluate(() => window.riemap.link());
        assert.ok(long.startsWith('#s=') && long.length <= 8193, `it carries 6,000 points, with fewer: ${long.length}`);
      }),
    );
  },
  { packed: true, below: '/a/b/' },
);
