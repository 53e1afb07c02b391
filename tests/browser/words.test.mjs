// The texts of the page: the same ones in both languages, and the choice of the user's language.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import test from 'node:test';

const WORDS = new URL('../../web/app/words.js', import.meta.url);
let count = 0;

/** The texts for an address, a browser's languages and a stored preference; `kept: null`: no storage is available. */
async function wordsFor({ search = '', languages = ['en'], kept }) {
  globalThis.location = { search };
  Object.defineProperty(globalThis, 'navigator', { value: { languages }, configurable: true });
  const stored = { getItem: (key) => (key === 'riemap preferences' && kept) || null };
  Object.defineProperty(globalThis, 'localStorage', {
    get: () => (kept === null ? assert.fail('forbidden') : stored),
    configurable: true,
  });
  const source = await readFile(WORDS, 'utf8');
  count += 1; // makes the address below unique, since a module is loaded only once per address
  const module = await import(`data:text/javascript,${encodeURIComponent(`${source}\n// ${count}`)}`);
  return module.words;
}

/** The names of all texts, including nested ones. */
const names = (words, at = '') =>
  Object.entries(words).flatMap(([name, text]) =>
    typeof text === 'object' ? names(text, `${at}${name}.`) : [`${at}${name}`],
  );

test('both languages have all words, and none is the same in both', async () => {
  const [english, german] = [await wordsFor({}), await wordsFor({ languages: ['de-AT', 'en'] })];
  assert.deepEqual(names(german), names(english));
  const of = (words, name) => name.split('.').reduce((inner, key) => inner[key], words);
  for (const name of names(english)) {
    assert.ok(of(german, name), name);
    assert.notEqual(of(german, name), of(english, name), name);
  }
});

test('the address decides, then what was chosen, then the browser', async () => {
  const kept = '{"language":"de"}';
  const language = async (requested) => (await wordsFor(requested)).language;
  assert.equal(await language({ search: '?lang=en', languages: ['de'], kept }), 'en');
  assert.equal(await language({ languages: ['fr', 'en'], kept }), 'de');
  assert.equal(await language({ languages: ['fr', 'de'], kept: 'no JSON' }), 'de');
  assert.equal(await language({ languages: ['fr', 'de'], kept: null }), 'de');
  assert.equal(await language({ languages: ['fr'] }), 'en');
});
