// Tables that sort by a click on a column's name and show the rows that a filter leaves.

const rowsAtOnce = 100;
let rowsInOrder = [];  // details that the table from which one was opened shows, in its order

// "misfit > 2, material = S355": a column with a number or a word, or letters that any cell has; all of
// them hold. @return for each what a row must fulfil, or, in place of it, what is wrong
function conditionsOf(text, columns) {
  return text.split(",").map((part) => part.trim()).filter((part) => part !== "").map((part) => {
    const letters = part.toLowerCase();
    const match = /^(.+?)\s*(<=|>=|<|>|=)\s*(.+)$/.exec(part);
    if (!match) return (row) => row.some((cell) => String(shown(cell)).toLowerCase().includes(letters));
    const [, name, sign, wanted] = match;
    const has = (fits) => columns.findIndex((column) => fits(column.name.toLowerCase()));
    const exact = has((column) => column === name.toLowerCase());
    const at = exact >= 0 ? exact : has((column) => column.startsWith(name.toLowerCase()));
    if (at < 0) return `there is no column ${name}`;
    const number = Number(wanted);
    if (sign !== "=" && !Number.isFinite(number)) return `${wanted} is no number`;
    const compare = { "<": (v) => v < number, ">": (v) => v > number, "<=": (v) => v <= number,
      ">=": (v) => v >= number, "=": (v) => v === number || shown(v) === shown(number) }[sign];
    return (row) => {
      if (row[at] === null || row[at] === "") return false;
      if (sign === "=" && String(row[at]).toLowerCase() === wanted.toLowerCase()) return true;
      const value = quantityOf(row[at])?.number;  // groups are words that may be numbers
      return Number.isFinite(value) && Number.isFinite(number) && compare(value);
    };
  });
}

// The number and unit that a cell is: "302.9 MPa".
function quantityOf(cell) {
  if (typeof cell === "number") return { number: cell, unit: "" };
  const match = /^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)(?: (\S+))?$/i.exec(String(cell));
  return match ? { number: Number(match[1]), unit: match[2] ?? "" } : undefined;
}

function compareCells(a, b) {
  if (a === null || b === null) return (a === null) - (b === null);  // what is missing stands last
  const [x, y] = [quantityOf(a), quantityOf(b)];
  if (x && y && x.unit === y.unit) return x.number - y.number;
  return String(a).localeCompare(String(b), undefined, { numeric: true });
}

function classOf(column, cell) {
  if (column.numbers) return "number";
  return String(cell ?? "").length > 24 ? "long" : "";
}

// A choice for each column of few words.
function choicesOf(block) {
  return block.columns.flatMap((column, c) => {
    if (column.numbers) return [];
    const words = [...new Set(block.rows.map((row) => row[c]).filter((word) => word !== null))];
    return words.length > 1 && words.length <= 12 && words.length < block.rows.length
      ? [{ at: c, words: words.sort(compareCells) }] : [];
  });
}

function tableBlock(block, openDetail) {
  let sortedBy = -1;
  let falling = false;
  let most = rowsAtOnce;
  const chosen = new Map();
  const input = make("input", { type: "search", placeholder: "filter: letters, column > number",
    "aria-label": "filter the rows" });
  const count = make("span", { className: "count", role: "status" });
  const body = make("tbody");
  const more = make("button", { type: "button", className: "more" }, "more rows");
  const order = block.rows.map((_, i) => i);
  let rows = order;  // that the filter leaves
  const detailOf = (i) => block.details?.[i] ?? i;

  const heads = block.columns.map((column, c) => {
    const button = make("button", { type: "button", title: column.about || "sort" },
      withUnit(column.name, column.unit));
    const head = make("th", { scope: "col", className: column.numbers ? "number" : "", "aria-sort": "none" },
      button);
    button.addEventListener("click", () => {
      falling = sortedBy === c ? !falling : false;
      sortedBy = c;
      heads.forEach((other) => other.setAttribute("aria-sort", "none"));
      head.setAttribute("aria-sort", falling ? "descending" : "ascending");
      order.sort((i, k) => {
        const a = block.rows[i][c];
        const b = block.rows[k][c];
        const sign = falling && a !== null && b !== null ? -1 : 1;
        return sign * compareCells(a, b) || i - k;
      });
      show();
    });
    return head;
  });

  function rowOf(i) {
    const cells = block.rows[i].map((cell, c) =>
      make("td", { className: classOf(block.columns[c], cell) }, shown(cell, block.columns[c].digits)));
    if (!block.opens) return make("tr", {}, ...cells);
    const link = make("a", { href: `#detail=${detailOf(i)}` }, shown(block.rows[i][0]));
    cells[0].replaceChildren(link);
    const row = make("tr", { className: "opens" }, ...cells);
    row.addEventListener("click", (event) => {
      rowsInOrder = [...new Set(rows.map(detailOf))];
      if (event.target !== link && String(getSelection()) === "") openDetail(detailOf(i));
    });
    return row;
  }

  function left(conditions) {
    return order.filter((i) => conditions.every((holds) => holds(block.rows[i])) &&
      [...chosen].every(([c, word]) => word === "" || String(block.rows[i][c]) === word));
  }

  function show() {
    const conditions = conditionsOf(input.value, block.columns);
    const wrong = conditions.find((condition) => typeof condition === "string");
    rows = wrong ? [] : left(conditions);
    body.replaceChildren(...rows.slice(0, most).map(rowOf));
    count.textContent = wrong ?? (rows.length === block.rows.length
      ? `${rows.length} rows` : `${rows.length} of ${block.rows.length} rows`);
    more.hidden = rows.length <= most;
  }

  const selects = choicesOf(block).map(({ at, words }) => {
    const select = make("select", { "aria-label": block.columns[at].name },
      make("option", { value: "" }, `${block.columns[at].name}: all`),
      ...words.map((word) => make("option", { value: String(word) }, String(word))));
    select.addEventListener("change", () => {
      chosen.set(at, select.value);
      most = rowsAtOnce;
      show();
    });
    return select;
  });
  input.addEventListener("input", () => {
    most = rowsAtOnce;
    show();
  });
  more.addEventListener("click", () => {
    most += 5 * rowsAtOnce;
    show();
  });
  const tools = block.rows.length > 5
    ? make("div", { className: "tools" }, input, ...selects, count) : null;
  show();
  return make("section", {}, block.title ? make("h2", {}, block.title) : null, tools,
    make("div", { className: "scroll" },
      make("table", { className: "sorts" }, make("thead", {}, make("tr", {}, ...heads)), body)),
    more);
}
