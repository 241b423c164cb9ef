// What the other scripts share. All texts of users go into the page as text nodes, never as HTML.
const report = JSON.parse(document.getElementById("data").textContent);

// An element with properties, and children that are elements or texts.
function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith("aria-") || name === "role") element.setAttribute(name, value);
    else element[name] = value;
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

// Columns of `packed_points`: numbers, and null in gaps.
function unpack(packed) {
  return packed.columns.map((text, c) => {
    const bytes = atob(text);
    const [low, high] = [packed.low[c], packed.high[c]];
    const logarithmic = packed.logarithmic?.[c === 0 ? 0 : 1];
    return Array.from({ length: packed.n }, (_, i) => {
      const step = bytes.charCodeAt(2 * i) + 256 * bytes.charCodeAt(2 * i + 1);
      if (step === 65535) return null;
      const value = low * (1 - step / 65534) + high * (step / 65534);  // whose sizes may overflow
      return logarithmic ? 10 ** value : value;
    });
  });
}

// Five digits, without an exponent where that is readable.
function shown(value, digits = 5) {
  if (value === null || value === undefined) return "";
  if (typeof value !== "number") return String(value);
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  if (size < 1e-4 || size >= 1e7) {
    return value.toExponential(digits - 1).replace(/\.?0+e/, "e").replace("e+", "e");
  }
  if (Number.isInteger(value)) return String(value);
  const text = value.toPrecision(digits);
  return text.includes("e") ? String(Number(text)) : text.replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "");
}

function withUnit(name, unit) {
  return unit ? `${name} [${unit}]` : name;
}

function themeColor(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

// The dark line colour of pictures is that of letters here, so that it is seen on a dark page.
function lineColor(color) {
  return color === "#333333" ? themeColor("--ink") : color;
}

// Digits of numbers that were packed: what they were rounded to is seen in the fifth.
const packedDigits = 4;

// Digits that tell numbers apart which lie between two.
function digitsBetween(low, high, least) {
  const size = Math.max(Math.abs(low), Math.abs(high));
  const digits = least - 1 + Math.ceil(Math.log10(size / (high - low)));
  return Number.isFinite(digits) ? Math.min(15, Math.max(least, digits)) : least;
}

// A list of numbers that is made when it is opened: what a picture shows, for those who cannot see
// it. Its function `renew` makes it again.
function numbersBehind(title, heads, rows) {
  const most = 2000;
  const summary = make("summary", {}, title);
  const details = make("details", { className: "numbers" }, summary);
  details.renew = () => {
    if (!details.open) return;
    const all = rows();
    const digits = heads.map((_, k) => {
      let low = Infinity;
      let high = -Infinity;
      for (const row of all) {
        if (typeof row[k] !== "number") continue;
        low = Math.min(low, row[k]);
        high = Math.max(high, row[k]);
      }
      return digitsBetween(low, high, packedDigits);
    });
    const table = make("table", {},
      make("thead", {}, make("tr", {}, ...heads.map((head) => make("th", { scope: "col" }, head)))),
      make("tbody", {}, ...all.slice(0, most).map((row) =>
        make("tr", {}, ...row.map((cell, k) => make("td", {}, shown(cell, digits[k])))))));
    details.replaceChildren(summary, make("div", { className: "scroll" }, table));
    if (all.length > most) details.append(make("p", {}, `the first ${most} of ${all.length} rows`));
  };
  details.addEventListener("toggle", details.renew);
  return details;
}
