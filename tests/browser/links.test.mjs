// Where every link of every page leads, and what the pages weigh.
import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { dirname, join, normalize } from "node:path";
import { test } from "node:test";
import { files, pages, report } from "./browser.mjs";

const text = page => readFileSync(join(report, page), "utf8");

test("links lead to files and places that are there", () => {
  const all = new Set(files()), dead = [];
  const ids = Object.fromEntries(pages().map(page => [page, new Set([...text(page).matchAll(/ id="([^"]*)"/g)].map(m => m[1]))]));
  for (const page of pages())
    for (const [, link] of text(page).matchAll(/ (?:href|src)="([^"]*)"/g)) {
      if (page === "benchmark.html" && link.startsWith("https://")) continue; // the source of a published cost
      const [path, place] = link.split("#");
      const target = path === "" ? page : normalize(join(dirname(page), decodeURIComponent(path)));
      if (!all.has(target) || (place && ids[target] && !ids[target].has(place))) dead.push(`${page}: ${link}`);
    }
  assert.deepEqual(dead, []);
});

test("the first page is below 300 kB, all pages with their scripts are below 4 MB", () => {
  const size = file => statSync(join(report, file)).size;
  const all = files().filter(file => /\.(html|css|js)$/.test(file)).reduce((sum, file) => sum + size(file), 0);
  console.log(`index.html ${size("index.html")} bytes, all ${pages().length} pages ${all} bytes`);
  assert.ok(size("index.html") < 300e3);
  assert.ok(all < 4e6);
});
