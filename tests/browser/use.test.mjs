// What people do on the pages: open, filter, sort, search, copy, point, print.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { address, files, inWindow, launch, pages, report } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const at = (file, use, options = {}) =>
  inWindow(browser, options, async page => {
    await page.goto(address(file));
    await use(page);
  });

/** The first page of a folder whose text holds this. */
function pageWith(folder, text) {
  const found = pages().find(file => file.startsWith(folder) && readFileSync(join(report, file), "utf8").includes(text));
  assert.ok(found, `no page in ${folder} has ${text}`);
  return found;
}

const asPeopleCount = (a, b) => a.localeCompare(b, undefined, { numeric: true });

const shown = (page, selector) => page.locator(selector).filter({ visible: true }).count();

test("the first page opens within a second", () =>
  inWindow(browser, {}, async page => {
    await page.goto("about:blank");
    const start = Date.now();
    await page.goto(address("index.html"), { waitUntil: "load" });
    const took = Date.now() - start;
    console.log(`index.html opens in ${took} ms`);
    assert.ok(took < 1000, `${took} ms`);
    assert.equal(await page.locator(".tile").count(), 4);
  }));

test("cards are filtered by their verdicts and by words", () =>
  at("index.html", async page => {
    const all = await shown(page, ".paper .card");
    const verdict = await page.locator(".paper .card").first().getAttribute("data-verdict");
    await page.locator(`#claims input[value=${verdict}]`).check();
    const some = await shown(page, ".paper .card");
    assert.equal(some, await page.locator(`.paper .card[data-verdict=${verdict}]`).count());
    await page.locator("#claims input[type=search]").fill(await page.locator(".paper .card").first().getAttribute("data-id"));
    assert.ok((await shown(page, ".paper .card")) >= 1 && (await shown(page, ".paper .card")) <= some);
    await page.locator("#claims input[type=search]").fill("no claim says this");
    assert.equal(await shown(page, ".paper .card"), 0);
    assert.equal(await page.locator("#claims [data-count]").innerText(), `0 of ${all}`);
  }));

const ids = page => page.locator(".paper:first-of-type .card").evaluateAll(cards => cards.map(card => card.dataset.id));

test("cards are sorted by their ids, as people count, and back", () =>
  at("index.html", async page => {
    const before = await ids(page);
    await page.locator("#claims select").selectOption("id");
    assert.deepEqual(await ids(page), [...before].sort(asPeopleCount));
    await page.locator("#claims select").selectOption("");
    assert.deepEqual(await ids(page), before);
  }));

test("cards stand in the order that the browser restores", () =>
  at("index.html", async page => {
    await page.locator("#claims select").selectOption("id");
    const sorted = await ids(page);
    await page.goto(address("gate.html"));
    await page.goBack();
    assert.equal(await page.locator("#claims select").inputValue(), "id");
    assert.deepEqual(await ids(page), sorted);
  }));

test("studies are sorted by a column, both ways", () =>
  at("index.html", async page => {
    const points = () => page.locator("#study-list tbody tr td:nth-child(4)").evaluateAll(cells => cells.map(c => Number(c.textContent)));
    const head = page.locator("#study-list th", { hasText: "points" });
    await head.locator("button").click();
    const up = await points();
    assert.deepEqual(up, [...up].sort((a, b) => a - b));
    assert.equal(await head.getAttribute("aria-sort"), "ascending");
    await head.locator("button").click();
    assert.deepEqual(await points(), [...up].reverse().sort((a, b) => b - a));
  }));

test("studies are sorted by their names, as people count, and by the worst of their goldens", () =>
  at("index.html", async page => {
    for (const column of [0, 4]) {
      await page.locator("#study-list thead button").nth(column).click();
      const keys = await page.locator("#study-list tbody tr").evaluateAll(
        (rows, of) => rows.map(row => (row.cells[of].dataset.key ?? row.cells[of].textContent).trim()), column);
      assert.deepEqual(keys, [...keys].sort(asPeopleCount));
    }
  }));

test("the gate folds what passes, and searches; without goldens it says how to make some", () =>
  at("gate.html", async page => {
    if ((await page.locator(".goldens").count()) === 0) {
      assert.match(await page.locator("main").innerText(), /No goldens were judged.*mpmvv propose/s);
      assert.equal(await page.locator("form").count(), 0);
      return;
    }
    assert.equal(await page.locator(".goldens[data-verdict=pass][open]").count(), 0);
    assert.equal(await page.locator(".goldens:not([data-verdict=pass]):not([open])").count(), 0);
    const study = (await page.locator(".goldens strong").last().innerText()).trim();
    await page.locator("input[type=search]").fill(study);
    assert.ok((await shown(page, ".goldens")) >= 1);
    await page.locator("button", { hasText: "Unfold all" }).click();
    assert.ok((await shown(page, ".goldens tbody tr")) >= 1);
  }));

/** What the clipboard has after a click on the point that a figure tells; before it has "kept". */
async function clicked(page, plot) {
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.evaluate(() => navigator.clipboard.writeText("kept"));
  await plot.dispatchEvent("click");
  return page.evaluate(() => navigator.clipboard.readText());
}

test("a point of a check, which has no command of its own, copies none", async () => {
  const points = files().find(file => file.startsWith("points/") && !readFileSync(join(report, file), "utf8").includes('"command":'));
  await at(pageWith("studies/", points), async page => {
    const plot = page.locator(`figure:has(script[src$="${points}"]) .plot`);
    await plot.focus();
    await page.keyboard.press("ArrowRight");
    assert.ok(await page.locator("#tip").isVisible());
    assert.equal(await clicked(page, plot), "kept");
    assert.notEqual(await plot.evaluate(element => getComputedStyle(element).cursor), "pointer");
  });
});

test("a point tells its case, its value and the command that repeats it", async () => {
  const text = file => readFileSync(join(report, file), "utf8");
  const points = files().find(file => file.startsWith("points/") && text(file).includes('"command":"mpmvv run'));
  const data = JSON.parse(text(points).match(/, (\{.*\})\);/)[1]);
  await at(pageWith("studies/", points), async page => {
    const plot = page.locator(`figure:has(script[src$="${points}"]) .plot`);
    await plot.scrollIntoViewIfNeeded();
    const [series] = data.series, [x, y, swept, value] = series.points[0];
    const box = await plot.locator("img").boundingBox();
    const scale = box.width / Number(await plot.locator("img").getAttribute("width"));
    await page.mouse.move(box.x + x * scale + 1, box.y + y * scale + 1);
    const tip = await page.locator("#tip").innerText();
    assert.ok(data.series.some(s => tip.includes(s.name)), tip);
    assert.match(tip, new RegExp(`${data.key} = `));
    assert.match(tip, /mpmvv run --problem/);
    await page.mouse.move(1, 1);
    assert.ok(await page.locator("#tip").isHidden());
    await plot.focus();
    await page.keyboard.press("ArrowRight");
    const first = await page.locator("#tip").innerText();
    for (const part of [series.name, swept, value]) assert.ok(first.includes(part), `${part} in ${first}`);
    assert.match(await clicked(page, plot), /^mpmvv run --problem/);
    assert.equal(await plot.evaluate(element => getComputedStyle(element).cursor), "pointer");
    await page.keyboard.press("ArrowRight");
    assert.notEqual(await page.locator("#tip").innerText(), first);
    await page.keyboard.press("Escape");
    assert.ok(await page.locator("#tip").isHidden());
  });
});

test("a command is copied with one click", async () => {
  await at(pageWith("studies/", 'class="command"'), async page => {
    await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
    await page.locator(".command button").first().click();
    const copied = await page.evaluate(() => navigator.clipboard.readText());
    assert.equal(copied, await page.locator(".command code").first().textContent());
    assert.match(copied, /^mpmvv study /);
  });
});

test("everything is reached by the keyboard", () =>
  at("index.html", async page => {
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.textContent), "Skip to the content");
    await page.keyboard.press("Enter");
    assert.equal(await page.evaluate(() => document.activeElement.id), "content");
    await page.keyboard.press("Tab");
    assert.ok(await page.evaluate(() => document.activeElement.matches(".tile")));
  }));

test("what is printed has no bars of buttons, and black text on white", () =>
  at("index.html", async page => {
    await page.emulateMedia({ media: "print", colorScheme: "dark" });
    assert.equal(await shown(page, ".top, .tools, .skip"), 0);
    const [ink, paper] = await page.evaluate(() => [getComputedStyle(document.body).color, getComputedStyle(document.body).backgroundColor]);
    assert.deepEqual([ink, paper], ["rgb(0, 0, 0)", "rgb(255, 255, 255)"]);
    assert.ok((await page.pdf()).length > 10000);
  }));

test("what is folded is printed", () =>
  at("gate.html", async page => {
    assert.ok((await shown(page, ".goldens:not([open])")) > 0);
    assert.equal(await shown(page, ".goldens:not([open]) tbody tr"), 0);
    await page.emulateMedia({ media: "print" });
    assert.ok((await shown(page, ".goldens:not([open]) tbody tr")) > 0);
  }));
