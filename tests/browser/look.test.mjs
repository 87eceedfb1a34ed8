// How the pages look: at the width of a phone and of a desk, in both themes, to people who do not see them.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { address, inWindow, kinds, launch, pages } from "./browser.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const themes = ["light", "dark"], widths = [390, 1300];

/** In the page: what does not fit. Regions that scroll may hold what is wider than they are. */
function misfits() {
  const found = [];
  const say = (what, element) => found.push(`${what}: <${element.tagName.toLowerCase()}> ${element.textContent.trim().slice(0, 60)}`);
  if (document.documentElement.scrollWidth > innerWidth) found.push(`the page is ${document.documentElement.scrollWidth} pixels wide`);
  const clips = style => style.overflowX === "hidden" || style.overflowX === "clip";
  for (const element of document.querySelectorAll("body *"))
    if (clips(getComputedStyle(element)) && element.scrollWidth > element.clientWidth + 1) say("clipped", element);
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const range = document.createRange();
  while (texts.nextNode()) {
    const text = texts.currentNode, parent = text.parentElement;
    if (parent.closest("script, pre, code, [hidden], details:not([open])") || !parent.checkVisibility()) continue;
    for (const { index, 0: number } of text.data.matchAll(/(?<![\w.])[-−]?\d+([.,]\d+)*(e[-+]?\d+)?(?!\w)/g)) {
      range.setStart(text, index), range.setEnd(text, index + number.length);
      const lines = new Set([...range.getClientRects()].filter(r => r.width > 0).map(r => Math.round(r.top)));
      if (lines.size > 1) say(`'${number}' in ${lines.size} lines`, parent);
    }
  }
  return found.slice(0, 8);
}

for (const width of widths)
  test(`no text is clipped and no number broken at ${width} pixels`, async t => {
    for (const file of pages())
      await t.test(file, () =>
        inWindow(browser, { viewport: { width, height: 900 } }, async page => {
          await page.goto(address(file));
          await page.evaluate(() => document.querySelectorAll("details").forEach(details => (details.open = true)));
          assert.deepEqual(await page.evaluate(misfits), []);
        }));
  });

test("on a phone, what was compared has the width of the page, and what was found stands below it", () =>
  inWindow(browser, { viewport: { width: 390, height: 900 } }, async page => {
    await page.goto(address(pages().find(file => file.startsWith("claims/"))));
    const [what, found, bar] = await page.evaluate(() => {
      const row = [...document.querySelectorAll(".criteria tr")].find(r => r.querySelector(".bar"));
      return [row.cells[0], row.cells[2], row.querySelector(".bar")].map(e => e.getBoundingClientRect().toJSON());
    });
    assert.ok(what.width > 320 && found.top >= what.bottom, JSON.stringify([what, found]));
    assert.ok(bar.width > 90 && bar.right <= what.right, JSON.stringify([what, bar]));
  }));

test("on a phone, a golden's numbers stand below its name", () =>
  inWindow(browser, { viewport: { width: 390, height: 900 } }, async page => {
    await page.goto(address("gate.html"));
    await page.evaluate(() => document.querySelectorAll("details").forEach(details => (details.open = true)));
    const rows = await page.locator(".judged tbody tr").evaluateAll(all =>
      all.map(row => [...row.cells].slice(0, 4).map(cell => cell.getBoundingClientRect().toJSON())));
    for (const [name, verdict, , measured] of rows) assert.ok(verdict.top >= name.bottom - 1 && measured.right <= name.right + 1);
  }));

test("no word of a command is broken at its hyphens", () =>
  inWindow(browser, { viewport: { width: 390, height: 900 } }, async page => {
    await page.goto(address(pages().find(file => file.startsWith("studies/"))));
    await page.evaluate(() => document.querySelectorAll("details").forEach(details => (details.open = true)));
    const heights = await page.locator("p.command .word").evaluateAll(words => words.map(w => w.getBoundingClientRect().height));
    assert.ok(heights.length > 3 && Math.max(...heights) < 1.5 * Math.min(...heights), `${heights}`);
  }));

test("every page in the dark is dark, and so are its figures", async t => {
  for (const file of kinds())
    await t.test(file, () =>
      inWindow(browser, { colorScheme: "dark" }, async page => {
        await page.goto(address(file));
        const [ink, paper] = await page.evaluate(() =>
          ["color", "backgroundColor"].map(of => Math.max(...getComputedStyle(document.body)[of].match(/\d+/g).slice(0, 3).map(Number))));
        assert.ok(ink > 200 && paper < 40, `ink ${ink}, paper ${paper}`);
        const filters = await page.locator("img").evaluateAll(pictures => pictures.map(p => getComputedStyle(p).filter));
        assert.ok(filters.every(filter => filter.startsWith("invert")));
      }));
});

for (const colorScheme of themes)
  test(`axe finds nothing serious in the ${colorScheme}`, async t => {
    for (const file of kinds())
      for (const width of widths)
        await t.test(`${file} at ${width}`, () =>
          inWindow(browser, { colorScheme, viewport: { width, height: 900 } }, async page => {
            await page.goto(address(file));
            await page.evaluate(axe);
            const { violations } = await page.evaluate(() => globalThis.axe.run({ preload: false }));
            const serious = violations
              .filter(v => v.impact === "serious" || v.impact === "critical")
              .map(v => `${v.id}: ${v.help}: ${v.nodes.slice(0, 3).map(n => n.html.slice(0, 160)).join(" | ")}`);
            assert.deepEqual(serious, []);
          }));
  });

test("every picture is there and says what it shows", async t => {
  for (const file of kinds())
    await t.test(file, () =>
      inWindow(browser, {}, async page => {
        await page.goto(address(file));
        const pictures = page.locator("main img");
        for (const picture of await pictures.all()) {
          await picture.evaluate(img => ((img.loading = "eager"), img.decode()));
          assert.ok(await picture.evaluate(img => img.naturalWidth > 0));
          assert.ok((await picture.getAttribute("alt")).length > 20);
        }
      }));
});
