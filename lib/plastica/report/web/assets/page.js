// Tabs, and the details that rows of tables open. What is shown stands in the address, so that the
// browser's way back works.

const blockMakers = {
  text: (block) => make("section", {}, make("h2", {}, block.title), make("pre", {}, block.text)),
  notes: (block) => make("section", { className: block.tone },
    block.title ? make("h2", {}, block.title) : null, make("ul", {}, ...block.notes.map((note) => make("li", {}, note)))),
  facts: (block) => make("section", {}, block.title ? make("h2", {}, block.title) : null,
    make("dl", {}, ...block.rows.flatMap(([name, what]) =>
      [make("dt", {}, name), make("dd", {}, what)]))),
  table: tableOnce,
  figure: (block) => figureBlock(block),
  map: (block) => mapBlock(block),
  beam: (block) => beamBlock(block),
};

// Tables are made once, so that the way back finds them filtered and sorted as they were.
const tables = new Map();
function tableOnce(block) {
  if (!tables.has(block)) {
    tables.set(block, tableBlock(block, (i) => { location.hash = `detail=${i}`; }));
  }
  return tables.get(block);
}

// The pattern "tabs" of the WAI-ARIA Authoring Practices: one panel, named by the tab that is chosen.
const panel = make("div", { id: "panel", role: "tabpanel" });
const main = make("main", { tabIndex: -1 }, panel);
const tabButtons = report.tabs.map((tab, i) => {
  const button = make("button", { type: "button", id: `tab-${i}`, role: "tab", "aria-controls": "panel" },
    tab.name);
  button.addEventListener("click", () => { location.hash = `tab=${i}`; });
  return button;
});
let lastTab = 0;

function stepTab(event) {
  const last = tabButtons.length - 1;
  const next = { ArrowRight: lastTab === last ? 0 : lastTab + 1, ArrowLeft: lastTab === 0 ? last : lastTab - 1,
    Home: 0, End: last }[event.key];
  if (next === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  location.hash = `tab=${next}`;
  tabButtons[next].focus();
}

function blocksOf(part) {
  return part.blocks.map((block) => blockMakers[block.kind](block));
}

// The detail so many rows further down the table; of one that the table does not show the file's order.
function neighbour(i, step) {
  const at = rowsInOrder.indexOf(i);
  const to = at < 0 ? i + step : rowsInOrder[at + step];
  return to >= 0 && to < report.details.length ? to : undefined;
}

function detailView(i) {
  const link = (step, text) => neighbour(i, step) !== undefined
    ? make("a", { href: `#detail=${neighbour(i, step)}` }, text) : null;
  return [
    make("nav", { className: "detail" }, make("a", { href: `#tab=${lastTab}` }, "← all"),
      link(-1, "previous"), link(1, "next")),
    make("h1", {}, report.details[i].name),
    ...blocksOf(report.details[i]),
  ];
}

function show() {
  const [kind, number] = location.hash.slice(1).split("=");
  const i = Number(number);
  forgetCharts();
  stopBeams();
  const isDetail = kind === "detail" && Number.isInteger(i) && i >= 0 && i < report.details.length;
  if (!isDetail) lastTab = kind === "tab" && Number.isInteger(i) && i >= 0 && i < report.tabs.length ? i : 0;
  tabButtons.forEach((button, k) => {
    button.setAttribute("aria-selected", String(k === lastTab));
    button.tabIndex = k === lastTab ? 0 : -1;
  });
  panel.setAttribute("aria-labelledby", tabButtons[lastTab].id);
  panel.replaceChildren(...(isDetail ? detailView(i) : blocksOf(report.tabs[lastTab])));
  scrollTo(0, 0);
  if (isDetail) main.focus({ preventScroll: true });
}

// On paper all is light, and there.
function setTheme(theme) {
  if (theme) document.documentElement.dataset.theme = theme;
  else delete document.documentElement.dataset.theme;
}
let themeOnScreen;
addEventListener("beforeprint", () => {
  themeOnScreen = document.documentElement.dataset.theme;
  const wasDark = themeColor("--scheme") === "dark";
  setTheme("light");
  if (wasDark) show();
  drawAll();
});
addEventListener("afterprint", () => {
  setTheme(themeOnScreen);
  show();
});

function themeButton() {
  const button = make("button", { type: "button", className: "theme" }, "dark / light");
  button.addEventListener("click", () => {
    const dark = themeColor("--scheme") === "dark";
    setTheme(dark ? "light" : "dark");
    show();
  });
  return button;
}

const tabs = make("div", { role: "tablist", className: "tabs", "aria-label": "parts of the report" },
  ...tabButtons);
tabs.addEventListener("keydown", stepTab);
document.body.append(
  make("header", {}, themeButton(), make("h1", {}, report.title),
    ...report.lines.map((line) => make("p", {}, line)), tabs),
  main,
  make("footer", {}, make("p", {},
    "Made by Plastica. Curves are thinned and rounded to what a screen shows" +
    (report.numbers_in ? `; all numbers are in ${report.numbers_in}.` : ".")),
    make("details", {}, make("summary", {}, "Licence of Chart.js, which draws the curves"),
      make("pre", {}, report.license))));
document.addEventListener("keydown", (event) => {
  const [kind, number] = location.hash.slice(1).split("=");
  if (kind !== "detail" || event.target.matches("input, select, canvas") || event.ctrlKey || event.metaKey) return;
  const step = { j: 1, k: -1 }[event.key];
  if (event.key === "Escape") location.hash = `tab=${lastTab}`;
  else if (step && neighbour(Number(number), step) !== undefined) {
    location.hash = `detail=${neighbour(Number(number), step)}`;
  }
});
addEventListener("hashchange", show);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", show);
show();
