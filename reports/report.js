"use strict";

// What a report's pages do beside being read: filter and sort, copy a command, tell a point of a figure.

const all = (selector, within = document) => [...within.querySelectorAll(selector)];

/** Shows, of the elements that a form filters, those with every word of its search and one of its verdicts. */
function filter(form) {
  const words = form.elements.text.value.toLowerCase().split(/\s+/).filter(Boolean);
  const verdicts = all("input[name=verdict]:checked", form).flatMap(box => box.value.split(" "));
  const items = all(form.dataset.filters);
  for (const item of items) {
    const text = item.textContent.toLowerCase();
    item.hidden = !words.every(word => text.includes(word)) || (verdicts.length > 0 && !verdicts.includes(item.dataset.verdict));
  }
  for (const paper of all(".paper")) paper.hidden = all(".card:not([hidden])", paper).length === 0;
  const shown = items.filter(item => !item.hidden).length;
  form.querySelector("[data-count]").textContent = shown === items.length ? "" : `${shown} of ${items.length}`;
}

/** Which comes first: numbers by size, before texts; texts by the sizes of their numbers, S-fig4 before S-fig10. */
function compare(a, b) {
  if (typeof a !== typeof b) return typeof a === "number" ? -1 : 1;
  return typeof a === "number" ? a - b : a.localeCompare(b, undefined, { numeric: true });
}

const verdictOrder = ["refuted", "partly", "open", "confirmed", "shown"];

/** Puts the cards of each list into the order that a form asks for. */
function order(form) {
  const keys = {
    "": card => Number(card.dataset.place),
    id: card => card.dataset.id,
    verdict: card => verdictOrder.indexOf(card.dataset.verdict),
  };
  const key = keys[form.elements.order.value];
  for (const list of all(form.dataset.sorts)) {
    const cards = all(".card", list);
    cards.sort((a, b) => compare(key(a), key(b)) || a.dataset.place - b.dataset.place);
    list.append(...cards);
  }
}

function startForms() {
  all(".card").forEach((card, place) => (card.dataset.place = place));
  for (const form of all("form.tools")) {
    form.hidden = false;
    form.addEventListener("input", () => filter(form));
    form.addEventListener("submit", event => event.preventDefault());
    filter(form);
    if (!form.elements.order) continue;
    form.elements.order.addEventListener("change", () => order(form));
    order(form);
  }
  for (const button of all("[data-unfold]"))
    button.addEventListener("click", () => all(button.dataset.unfold).forEach(details => (details.open = true)));
}

/** A cell's own key, else the cell as a number where it begins with one, else as text. */
function cellKey(row, column) {
  const cell = row.cells[column], text = cell.dataset.key ?? cell.textContent.trim();
  const number = parseFloat(text);
  return Number.isNaN(number) ? text.toLowerCase() : number;
}

function sortRows(table, column, head) {
  const down = head.getAttribute("aria-sort") === "ascending";
  for (const other of all("thead th", table)) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", down ? "descending" : "ascending");
  const body = table.tBodies[0];
  const rows = [...body.rows].sort((a, b) => (down ? -1 : 1) * compare(cellKey(a, column), cellKey(b, column)));
  body.append(...rows);
}

function startTables() {
  for (const table of all("table.sortable"))
    all("thead th", table).forEach((head, column) => {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = head.textContent;
      button.addEventListener("click", () => sortRows(table, column, head));
      head.replaceChildren(button);
    });
}

/** Copies by the clipboard or, where the browser keeps that from a file, by a selection. */
async function copy(text, button) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const range = document.createRange();
    range.selectNodeContents(button.parentElement.querySelector("code"));
    getSelection().removeAllRanges();
    getSelection().addRange(range);
    document.execCommand("copy");
  }
  button.textContent = "Copied";
  setTimeout(() => (button.textContent = "Copy"), 1500);
}

/** Keeps the words of a command whole: a browser may break a line behind the first hyphen of --db. */
function keepWordsWhole(code) {
  code.replaceChildren(...code.textContent.split(/( +)/).map((word, place) => (place % 2 ? word : part("span", word, "word"))));
}

function startCopies() {
  for (const place of all(".command")) {
    const code = place.querySelector("code");
    if (place.matches("p")) keepWordsWhole(code);
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = "Copy";
    button.addEventListener("click", () => copy(code.textContent, button));
    place.prepend(button);
  }
}

/** The points of a figure: where in the picture's own pixels, and what to say of them. */
function pointsOf(data) {
  return data.series.flatMap(series =>
    series.points.map(([x, y, swept, value]) => ({
      x, y,
      title: series.name,
      text: `${swept === "" ? "" : `${data.key} = ${shorter(swept)}: `}${data.quantity} ${value}`,
      command: series.command && swept !== "" ? series.command.replace("{}", swept) : "",
      note: series.note || "",
    })));
}

const shorter = number => (number.length > 9 ? String(Number(Number(number).toPrecision(6))) : number);

/** Tells the points of one figure, by pointer, touch or arrow keys. */
class Plot {
  constructor(element, points) {
    this.element = element;
    this.picture = element.querySelector("img");
    this.points = points;
    this.ring = document.createElement("span");
    this.ring.className = "ring";
    this.at = -1;
    element.addEventListener("pointermove", event => this.seek(event));
    element.addEventListener("pointerleave", () => this.leave());
    element.addEventListener("click", () => this.copy());
    element.addEventListener("keydown", event => this.step(event));
    element.addEventListener("blur", () => this.leave());
  }

  scale() {
    return this.picture.getBoundingClientRect().width / this.picture.getAttribute("width");
  }

  seek(event) {
    const box = this.picture.getBoundingClientRect(), scale = this.scale();
    const away = this.points.map(p => Math.hypot(box.left + p.x * scale - event.clientX, box.top + p.y * scale - event.clientY));
    const nearest = away.indexOf(Math.min(...away));
    if (away[nearest] < 24) this.show(nearest);
    else this.leave();
  }

  step(event) {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (event.key === "Escape") this.leave();
    if (!step) return;
    event.preventDefault();
    this.show((this.at + step + this.points.length) % this.points.length);
  }

  /** Copies the command that repeats the point, where it has one. */
  copy() {
    const command = this.points[this.at]?.command;
    if (command) navigator.clipboard?.writeText(command);
  }

  show(place) {
    const point = this.points[place], scale = this.scale();
    this.at = place;
    this.element.classList.toggle("copies", point.command !== "");
    this.ring.style.left = `${point.x * scale}px`;
    this.ring.style.top = `${point.y * scale}px`;
    this.element.append(this.ring);
    tell(point, this.picture.getBoundingClientRect(), scale);
  }

  leave() {
    this.at = -1;
    this.element.classList.remove("copies");
    this.ring.remove();
    document.getElementById("tip").hidden = true;
  }
}

/** Called by points/NAME.js, which follows the figure that it tells of. */
function tellPoints(figure, data) {
  new Plot(document.getElementById(figure).querySelector(".plot"), pointsOf(data));
}

function part(tag, text, name = "") {
  const element = document.createElement(tag);
  element.textContent = text;
  element.className = name;
  return element;
}

/** Writes what is to be said of a point beside it, inside the window. */
function tell(point, box, scale) {
  const tip = document.getElementById("tip");
  tip.replaceChildren(part("strong", point.title), part("div", point.text));
  if (point.command) tip.append(part("code", point.command));
  if (point.note) tip.append(part("span", point.note, "soft"));
  tip.hidden = false;
  const x = box.left + point.x * scale, y = box.top + point.y * scale;
  const left = Math.max(4, Math.min(x + 14, innerWidth - tip.offsetWidth - 8));
  const below = y + 16 + tip.offsetHeight < innerHeight;
  tip.style.left = `${left}px`;
  tip.style.top = `${below ? y + 16 : Math.max(4, y - 16 - tip.offsetHeight)}px`;
}

/** "3 hours ago" in place of a time. */
function ago(time) {
  const hours = (Date.now() - new Date(time)) / 36e5;
  if (!(hours >= 0)) return "";
  if (hours < 1 / 60) return "just now";
  const [count, unit] = hours < 1 ? [Math.round(hours * 60), "minute"] : hours < 48 ? [Math.round(hours), "hour"] : [Math.round(hours / 24), "day"];
  return `${count} ${unit}${count === 1 ? "" : "s"} ago`;
}

function startAges() {
  for (const time of all("time[data-age]")) {
    const text = ago(time.dateTime);
    if (text) time.title = time.textContent, time.textContent = text;
  }
}

/** Keeps numbers as 1e-12 in one line, as a browser may break behind their hyphen, and cells = 16. */
function keepNumbersWhole() {
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const number = /((?:\w+ = )?\d[\d.]*e[-+]\d+|\w+ = \d[\d.]*)/;
  const inOneLine = "pre, .n, .results :is(td, [scope=row]):not([class])";
  const found = [];
  while (texts.nextNode())
    if (number.test(texts.currentNode.data) && !texts.currentNode.parentElement.closest(inOneLine)) found.push(texts.currentNode);
  for (const text of found)
    text.replaceWith(...text.data.split(number).map((words, place) => (place % 2 ? part("span", words, "whole") : words)));
}

keepNumbersWhole();
startForms();
startTables();
startCopies();
startAges();
