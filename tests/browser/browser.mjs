// Chromium of the system, and a report's pages in it. The report's folder is the first argument of a test's command line
// or REPORT in the environment.
import { chromium } from "playwright-core";
import { readdirSync, statSync } from "node:fs";
import { join, relative, resolve } from "node:path";
import { pathToFileURL } from "node:url";

export const report = resolve(process.env.REPORT ?? ".");

export const address = page => pathToFileURL(join(report, page)).href;

/** All files below a folder of the report, relative to it. */
export function files(folder = report) {
  return readdirSync(folder).sort().flatMap(name => {
    const path = join(folder, name);
    return statSync(path).isDirectory() ? files(path) : [relative(report, path)];
  });
}

export const pages = () => files().filter(file => file.endsWith(".html"));

/** The first page of each kind, those of claims and studies that have figures. */
export function kinds(all = pages()) {
  return ["index.html", "gate.html", "trend.html", "benchmark.html", "codes.html", "mutants.html", /^studies\//, /^claims\//]
    .map(kind => all.find(page => (typeof kind === "string" ? page === kind : kind.test(page))))
    .filter(Boolean);
}

export const launch = () =>
  chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu", "--disable-quic"] });

/** Calls `use` with a page of a window, whose mistakes and requests beyond files are thrown. */
export async function inWindow(browser, options, use) {
  const context = await browser.newContext({ viewport: { width: 1300, height: 900 }, ...options });
  const page = await context.newPage();
  const troubles = [];
  page.on("pageerror", error => troubles.push(String(error)));
  page.on("console", message => message.type() === "error" && troubles.push(message.text()));
  page.on("request", request => /^(file|data):/.test(request.url()) || troubles.push(`asks for ${request.url()}`));
  page.on("requestfailed", request => troubles.push(`has not got ${request.url()}`));
  try {
    await use(page);
  } finally {
    await context.close();
  }
  if (troubles.length > 0) throw new Error(troubles.join("\n"));
}
