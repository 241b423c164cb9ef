// Maps of two axes: a table of shaded cells, the larger the value the darker. One hue does for those
// who tell few colours apart, and on light and dark pages; cells without a value are hatched, each
// kind at an angle of its own and with a letter.

const lightestCell = [222, 235, 247];
const darkestCell = [8, 48, 107];
const mostNamedColumns = 14;  // cells of more have no room for their numbers
const mostNamedRows = 40;

function cellColors(kind, number) {
  if (typeof kind.fraction !== "number") {
    const angle = [45, 135, 0, 90][number % 4];
    return { ink: themeColor("--ink"),
      paper: `repeating-linear-gradient(${angle}deg, var(--panel) 0 5px, var(--grid) 5px 7px)` };
  }
  const parts = lightestCell.map((light, c) => Math.round(light + kind.fraction * (darkestCell[c] - light)));
  const lightness = 0.3 * parts[0] + 0.59 * parts[1] + 0.11 * parts[2];
  return { ink: lightness < 140 ? "#ffffff" : "#16191d", paper: `rgb(${parts.join(",")})` };
}

function letterOf(kind) {
  return typeof kind.fraction === "number" ? "" : kind.name[0];
}

// Names of every so many values, where all have no room.
function namesOf(values, most) {
  const every = Math.ceil(values.length / most);
  return values.map((value, i) => (i % every === 0 ? shown(value, packedDigits) : ""));
}

function mapTable(block, map) {
  const dense = block.x_values.length > mostNamedColumns || block.y_values.length > mostNamedRows;
  const colors = block.classes.map(cellColors);
  const at = new Map();  // cells by row and column: of several the first is shown, and all are said
  for (const cell of map.cells) {
    const key = `${cell.y} ${cell.x}`;
    at.set(key, [...(at.get(key) ?? []), cell]);
  }
  const told = (cell) => `${block.x} ${shown(block.x_values[cell.x])}, ${block.y} ${shown(block.y_values[cell.y])}: ` +
    `${cell.number || ""}${cell.number ? ` (${block.classes[cell.class].name})` : block.classes[cell.class].name}`;
  const xNames = namesOf(block.x_values, mostNamedColumns);
  const yNames = namesOf(block.y_values, mostNamedRows);
  const row = (_, up) => {
    const y = block.y_values.length - 1 - up;
    return make("tr", {}, make("th", { scope: "row" }, yNames[y]), ...block.x_values.map((__, x) => {
      const cells = at.get(`${y} ${x}`);
      if (!cells) return make("td");
      const [cell] = cells;
      const kind = block.classes[cell.class];
      const element = make("td", { title: cells.map(told).join("; "), className: block.opens ? "opens" : "" },
        dense ? letterOf(kind) : cell.number || kind.name);
      element.style.background = colors[cell.class].paper;
      element.style.color = colors[cell.class].ink;
      if (block.opens) element.addEventListener("click", () => { location.hash = `detail=${cell.case}`; });
      return element;
    }));
  };
  return make("table", { className: dense ? "map dense" : "map", "aria-label": `${block.what} over ${block.x} and ${block.y}` },
    make("thead", {},
      make("tr", {}, make("td"), ...xNames.map((name) => make("th", { scope: "col" }, name))),
      make("tr", {}, make("td"), make("th", { className: "axis", colSpan: block.x_values.length }, block.x))),
    make("tbody", {}, ...block.y_values.map(row)));
}

function mapBlock(block) {
  const legend = make("ul", { className: "classes" }, ...block.classes.map((kind, k) => {
    const sample = make("span", { "aria-hidden": "true" }, letterOf(kind));
    const { ink, paper } = cellColors(kind, k);
    sample.style.background = paper;
    sample.style.color = ink;
    return make("li", {}, sample, kind.name);
  }));
  const figures = block.maps.map((map) => make("figure", {},
    map.title ? make("figcaption", {}, map.title) : null,
    make("p", { className: "count" }, `${block.y} upwards`),
    make("div", { className: "scroll" }, mapTable(block, map)),
    numbersBehind("numbers", [block.x, block.y, block.what, "class"], () => map.cells.map((cell) =>
      [block.x_values[cell.x], block.y_values[cell.y], cell.amount, block.classes[cell.class].name]))));
  return make("section", {}, make("h2", {}, block.title),
    make("p", { className: "count" }, [block.what, block.limits].filter(Boolean).join("; ")), legend,
    make("div", { className: "panels" }, ...figures));
}
