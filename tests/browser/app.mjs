// Drives one running app by simulated input, and waits for states instead of times.

import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';

import { newPage } from './chromium.mjs';
import { watch } from './faults.mjs';
import { leaveScreenBlank } from './screen.mjs';

/** The folder in which screenshots are saved for somebody to look at, or undefined. */
const SHOTS = process.env.RIEMAP_SHOTS;

/**
 * Drawing in software takes time for every pixel, and most tests look at none: without a folder for screenshots the
 * layout is that of the whole screen, drawn with fewer pixels. A test of pixels asks for `SHARP` or `SHARP_PHONE`.
 */
export const SHARP = { deviceScaleFactor: 1 };
export const SHARP_PHONE = { deviceScaleFactor: 2 };
const DESKTOP = { viewport: { width: 1440, height: 900 }, deviceScaleFactor: SHOTS ? 1 : 0.5 };
const PHONE = { viewport: { width: 390, height: 844 }, deviceScaleFactor: SHOTS ? 2 : 1, hasTouch: true, isMobile: true };
export const DEVICES = { desktop: DESKTOP, phone: PHONE };

/** Positions that are unchanged for this many frames are final: an input has an effect after at most two frames. */
const STILL_FRAMES = 3;

/** Runs in the page before its scripts: makes it possible to hold back frames. */
function makeFramesHoldable() {
  const ask = window.requestAnimationFrame.bind(window);
  let held = null;
  window.requestAnimationFrame = (callback) => ask((time) => (held ? held.push(callback) : callback(time)));
  window.holdFrames = () => (held = []);
  window.releaseFrames = () => {
    const late = held;
    held = null;
    late.forEach((callback) => ask(callback));
  };
}

/** What every page of the app needs before its scripts run. */
async function makeTestable(page) {
  await page.addInitScript(makeFramesHoldable);
  if (!SHOTS) await page.addInitScript(leaveScreenBlank);
}

/** The app on one page. Faults of the page are recorded, and `during` fails if there are any. */
export class App {
  #page;
  #backend;
  #faults;
  #waits = 0;

  /** Opens an address in a page with the `options` of its context; `prepare` runs in the page before its scripts. */
  static async open(browser, address, { backend, prepare, ...options }) {
    const page = await newPage(browser, options);
    const app = new App(page, backend);
    await makeTestable(page);
    if (prepare) await page.addInitScript(prepare);
    await page.goto(address);
    return app;
  }

  constructor(page, backend) {
    this.#page = page;
    this.#backend = backend;
    this.#faults = watch(page.context());
    // with a listener the browser opens no system dialog; adding and removing one around each use sometimes misses
    page.on('filechooser', () => {});
    // after an uncaught error no state is reached; closing the page ends all waits
    page.on('pageerror', () => page.close());
    page.on('crash', () => {
      this.#faults.push('the page crashed');
      return page.close();
    });
  }

  /** Opens another tab as "Duplicate tab" does: with the address and the entry of the history of this one. */
  async duplicate() {
    const page = await this.#page.context().newPage();
    await makeTestable(page);
    await page.addInitScript((state) => {
      if (sessionStorage.getItem('duplicated')) return; // it is reloaded
      sessionStorage.setItem('duplicated', 'yes');
      history.replaceState(state, '');
    }, await this.#page.evaluate(() => history.state));
    await page.goto(this.address());
    return new App(page, this.#backend);
  }

  /** Runs `act` on the app, then closes it; fails if the test failed or a fault was recorded. */
  async during(act) {
    try {
      const { backend } = await this.atRest('a first map is shown');
      assert.equal(backend, this.#backend);
      await act();
    } catch (error) {
      throw this.#faults.length === 0 ? error : new Error(this.#faults.join('\n'), { cause: error });
    } finally {
      await this.#page.context().close();
    }
    assert.deepEqual(this.#faults, [], 'nothing goes wrong behind the scenes');
  }

  /** The page itself, for tests of what surrounds the app. */
  get page() {
    return this.#page;
  }

  stats() {
    return this.#page.evaluate(() => window.riemap.stats());
  }

  session() {
    return this.#page.evaluate(() => window.riemap.session());
  }

  /** Opens the current session with some fields changed. */
  async openSession(changes) {
    const refusal = await this.#page.evaluate(
      (changed) => window.riemap.open_session({ ...window.riemap.session(), ...changed }),
      changes,
    );
    assert.equal(refusal, null, 'the session is taken');
    await this.#frames();
  }

  /** The error of `riemap.open_session` for an invalid session. */
  refusalOf(value) {
    return this.#page.evaluate((given) => window.riemap.open_session(given), value);
  }

  /** Waits until `reached(stats, argument)`, evaluated in the page once per frame, and returns the stats. */
  until(state, reached, argument) {
    return this.#reach(state, `return (${reached})(stats, argument) ? stats : null;`, argument);
  }

  /** As `until`, and until dots and controls do not move, since a new view or window takes frames for its layout. */
  atRest(state, reached = (stats) => stats.ready, argument = null) {
    const wait = ++this.#waits;
    const body = `
      if (!(${reached})(stats, argument)) return null;
      const places = JSON.stringify([stats.handles, stats.editing, stats.export, stats.close]);
      const { still } = window.seen?.wait === ${wait} && window.seen.places === places ? window.seen : { still: 0 };
      window.seen = { wait: ${wait}, places, still: still + 1 };
      return still >= ${STILL_FRAMES} ? stats : null;`;
    return this.#reach(state, body, argument);
  }

  async #reach(state, body, argument) {
    // a function, since the page's content security policy forbids evaluating text
    const asked = new Function('argument', `const stats = window.riemap?.stats?.(); if (!stats) return null; ${body}`);
    try {
      return await (await this.#page.waitForFunction(asked, argument ?? null)).jsonValue();
    } catch (error) {
      const last = await this.#page.evaluate(() => JSON.stringify(window.riemap?.stats?.())).catch(String);
      throw new Error(`not reached: ${state}\nlast stats: ${last}`, { cause: error });
    }
  }

  /** Waits for animation frames: after one the app has processed its input, after two it has drawn the result. */
  #frames(count = 2) {
    const pass = (left) => new Promise((done) => {
      const next = () => (left-- > 0 ? requestAnimationFrame(next) : done());
      next();
    });
    return this.#page.evaluate(pass, count);
  }

  /** Drags with the mouse, one step per frame. */
  async drag(from, to, steps = 4) {
    await this.hold(from, to, steps);
    await this.letGo();
  }

  /** Moves the pointer to a point. */
  async pointAt(at) {
    await this.#page.mouse.move(...at);
    await this.#frames();
  }

  /** Clicks at a point. */
  async click(at) {
    await this.pointAt(at);
    await this.#betweenFrames(() => this.#page.mouse.click(...at));
  }

  /** Presses and releases within a frame: a press longer than 0.8 s, possible with slow frames, is not a click. */
  async #betweenFrames(press) {
    await this.#page.evaluate(() => window.holdFrames());
    await press();
    await this.#page.evaluate(() => window.releaseFrames());
    await this.#frames();
  }

  /** Starts a drag with the mouse without releasing the button. */
  async hold(from, to, steps = 4) {
    const { mouse } = this.#page;
    await this.pointAt(from);
    await mouse.down();
    await this.#frames();
    for (const point of between(from, to, steps)) {
      await mouse.move(...point);
      await this.#frames(1);
    }
    await this.#frames(1);
  }

  /** Releases the mouse button. */
  async letGo() {
    await this.#page.mouse.up();
    await this.#frames();
  }

  /** Pastes a text, as the browser does on Ctrl+V. */
  async pasteText(text) {
    await this.#page.evaluate((pasted) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData('text', pasted);
      const paste = new ClipboardEvent('paste', { bubbles: true, cancelable: true, clipboardData });
      (document.activeElement ?? document.querySelector('canvas')).dispatchEvent(paste);
    }, text);
    await this.#frames();
  }

  /** Drags with one finger. */
  async touchDrag(from, to, steps = 4) {
    const protocol = await this.#page.context().newCDPSession(this.#page);
    const touch = async (type, touchPoints) => {
      await protocol.send('Input.dispatchTouchEvent', { type, touchPoints });
      await this.#frames(1);
    };
    await touch('touchStart', [{ x: from[0], y: from[1] }]);
    await this.#frames(1);
    for (const [x, y] of between(from, to, steps)) await touch('touchMove', [{ x, y }]);
    await touch('touchEnd', []);
    await this.#frames(1);
  }

  /** Taps with one finger. */
  async tap(at) {
    await this.#betweenFrames(() => this.#page.touchscreen.tap(...at));
  }

  /** Starts a drag with one finger, which the system then cancels, as for one of its own gestures. */
  async touchTakenAway(from, to) {
    const protocol = await this.#page.context().newCDPSession(this.#page);
    const touch = async (type, touchPoints) => {
      await protocol.send('Input.dispatchTouchEvent', { type, touchPoints });
      await this.#frames();
    };
    await touch('touchStart', [{ x: from[0], y: from[1] }]);
    await touch('touchMove', [{ x: to[0], y: to[1] }]);
    await touch('touchCancel', []);
  }

  /** Opens the file dialog by `act` and chooses a file with this text; without a name the dialog is cancelled. */
  async inFileDialog(act, name, text = '') {
    const [chooser] = await Promise.all([this.#page.waitForEvent('filechooser'), act()]);
    if (name) await chooser.setFiles({ name, mimeType: 'application/octet-stream', buffer: Buffer.from(text) });
    else await chooser.element().dispatchEvent('cancel');
    await this.#frames();
  }

  async loadOutline(side, name, text) {
    await this.#page.evaluate((given) => window.riemap.load_outline(...given), [side, name, text]);
    await this.#frames();
  }

  /** Loads a file of any kind, given as bytes. */
  async loadFile(side, name, bytes) {
    await this.#page.evaluate(
      ([where, called, text]) => window.riemap.load_file(where, called, Uint8Array.from(atob(text), (c) => c.charCodeAt(0))),
      [side, name, bytes.toString('base64')],
    );
    await this.#frames();
  }

  /** The page's address. */
  address() {
    return this.#page.url();
  }

  /** Reloads the page and waits for its map. */
  async reload() {
    await this.#page.reload();
    return this.atRest('a map is shown again');
  }

  /** Waits until the address's fragment differs from `before`, and returns it. */
  async otherAddress(before) {
    const other = (old) => window.location.href !== old && window.location.href;
    return (await this.#page.waitForFunction(other, before)).jsonValue();
  }

  /** Navigates to another fragment, as if a link were pasted into the address bar. */
  async paste(fragment) {
    await this.#page.evaluate((hash) => (window.location.hash = hash), fragment);
    await this.#frames();
  }

  /** Presses a key combination, such as "Control+z". */
  async press(keys) {
    await this.#page.keyboard.press(keys);
    await this.#frames();
  }

  /** Presses Tab until a matching control is announced, as a user of a screen reader does. */
  async walkTo(control, furthest = 150) {
    const heard = [];
    let { spoken } = await this.stats();
    for (let step = 0; step < furthest; step++) {
      await this.#page.keyboard.press(step === 0 ? 'F6' : 'Tab');
      const said = await this.#saidAfter(spoken);
      spoken = said.spoken;
      heard.push(said.text);
      if (!control.test(said.text)) continue;
      // the announcement may belong to the previous key press; then the focus has already moved on
      await this.#frames();
      if (control.test(await this.#page.textContent('#spoken'))) return;
      await this.press('Shift+Tab');
      if (control.test(await this.#page.textContent('#spoken'))) return;
    }
    throw new Error(`no control ${control} among: ${heard.join(' | ')}`);
  }

  /** Unfolds the controls of the methods. */
  async unfoldAdvanced() {
    await this.walkTo(/^Advanced, button, not selected/);
    await this.press('Space');
  }

  /**
   * The last announcement and the number of them, once more than `before` controls have been announced; an empty text if none is:
   * the focus was in an offer whose time was over, and the next key press goes on from there.
   */
  async #saidAfter(before) {
    const said = (known) => {
      const { spoken } = window.riemap.stats();
      return spoken > known && { text: document.getElementById('spoken').textContent, spoken };
    };
    try {
      return await (await this.#page.waitForFunction(said, before, { timeout: 5_000 })).jsonValue();
    } catch (error) {
      if (error.name !== 'TimeoutError') throw error;
      return { text: '', spoken: before };
    }
  }

  /** Waits until a live region of the page has a matching text other than `before`, and returns it. */
  async saying(region, words, before = null) {
    const says = ([id, source, old]) => {
      const text = document.getElementById(id)?.textContent ?? '';
      return text !== old && new RegExp(source, 'u').test(text) ? text : null;
    };
    try {
      return await (await this.#page.waitForFunction(says, [region, words.source, before])).jsonValue();
    } catch (error) {
      throw new Error(`not said: ${words}, but: ${await this.#page.textContent(`#${region}`)}`, { cause: error });
    }
  }

  /** The language that the page declares. */
  language() {
    return this.#page.getAttribute('html', 'lang');
  }

  /** Sets the system's preference for light or dark. */
  prefer(colorScheme) {
    return this.#page.emulateMedia({ colorScheme });
  }

  /** Presses keys and returns the file that is downloaded. */
  downloadBy(keys) {
    return this.#downloaded(() => this.press(keys));
  }

  /** Clicks at a point of the window and returns the file that is downloaded. */
  download(at) {
    return this.#downloaded(() => this.click(at));
  }

  async #downloaded(act) {
    const [download] = await Promise.all([this.#page.waitForEvent('download'), act()]);
    const chunks = [];
    for await (const chunk of await download.createReadStream()) chunks.push(chunk);
    return { name: download.suggestedFilename(), bytes: Buffer.concat(chunks) };
  }

  /** Types into the number field at a point of the window. */
  async type(at, text) {
    await this.click(at);
    await this.press('Control+a');
    await this.#page.keyboard.type(text);
    await this.press('Enter');
  }

  /** The RGBA values of some pixels of a PNG. */
  pixelsOf(png, places) {
    return this.#page.evaluate(
      async ([base64, wanted]) => {
        const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }), { premultiplyAlpha: 'none' });
        const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
        context.drawImage(bitmap, 0, 0);
        return wanted.map(([x, y]) => [...context.getImageData(x, y, 1, 1).data]);
      },
      [png.toString('base64'), places],
    );
  }

  /** Drops a file on the canvas at a point of the window, as from a file manager. */
  dropFile(at, name, text) {
    return this.dropFiles(at, { [name]: Buffer.from(text) });
  }

  /** Drops files together: their names and bytes. */
  async dropFiles(at, files) {
    const encoded = Object.entries(files).map(([name, bytes]) => [name, bytes.toString('base64')]);
    await this.#page.evaluate(
      ([[clientX, clientY], dropped]) => {
        const dataTransfer = new DataTransfer();
        for (const [name, base64] of dropped) {
          dataTransfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name));
        }
        const canvas = document.querySelector('canvas');
        for (const type of ['dragenter', 'dragover', 'drop']) {
          canvas.dispatchEvent(
            new DragEvent(type, { bubbles: true, cancelable: true, clientX, clientY, dataTransfer }),
          );
        }
      },
      [at, encoded],
    );
    await this.#frames();
  }

  /** Takes a screenshot and returns the counts of its colors. */
  async picture(name) {
    const png = await this.screenshot(inShots(name));
    return this.#page.evaluate(countColours, png.toString('base64'));
  }

  /** Takes a screenshot for somebody to look at, if there is a folder for it. */
  async shot(name) {
    if (SHOTS) await this.screenshot(inShots(name));
  }

  /** What is on the screen, as PNG; `how`: Playwright's options. */
  async screenshot(how) {
    await this.#showScreen(true);
    const png = await this.#page.screenshot(how);
    await this.#showScreen(false);
    return png;
  }

  async #showScreen(shown) {
    await this.#page.evaluate((asked) => window.showScreen?.(asked), shown);
    await this.#frames();
  }
}

/** Saves a screenshot for somebody to look at, if there is a folder for it. */
function inShots(name) {
  if (!SHOTS) return {};
  mkdirSync(SHOTS, { recursive: true });
  return { path: join(SHOTS, `${name}.png`) };
}

function between(from, to, steps) {
  return Array.from({ length: steps }, (_, k) => from.map((start, axis) => start + ((to[axis] - start) * (k + 1)) / steps));
}

/** Runs in the page: the number of pixels of each color in steps of 16, the most frequent first. */
async function countColours(png) {
  const bytes = Uint8Array.from(atob(png), (c) => c.charCodeAt(0));
  const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
  const counts = new Map();
  for (let k = 0; k < data.length; k += 4) {
    const colour = (data[k] >> 4) * 256 + (data[k + 1] >> 4) * 16 + (data[k + 2] >> 4);
    counts.set(colour, (counts.get(colour) ?? 0) + 1);
  }
  return [...counts.values()].sort((a, b) => b - a);
}
