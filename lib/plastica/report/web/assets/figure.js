// Curves by Chart.js. Abscissas need not rise: a curve of a cyclic test runs back and forth. (Told not
// to parse its data, Chart.js would take them for sorted, and the axis from the first and the last.)

const charts = new Set();  // that are on the page

// By gnuplot's numbers; from 4 on each even one is as the next, open.
const pointStyles = { 1: "cross", 2: "crossRot", 3: "star", 5: "rect", 7: "circle", 9: "triangle", 11: "triangle", 13: "rectRot", 15: "star" };
const largeSymbol = 12;  // others are seen in it
const dashStyles = [[], [8, 4], [2, 3], [10, 3, 2, 3], [5, 5], [12, 4], [1, 4], [8, 3, 2, 3]];

function translucent(color) {
  return /^#[0-9a-f]{6}$/i.test(color) ? color + "80" : color;
}

// What a curve is for Chart.js: an area is two lines with the space between them filled.
function datasetsOf(curve) {
  const columns = unpack(curve.points);
  const color = lineColor(curve.color);
  const symbol = curve.symbol ?? 7;
  const open = symbol >= 4 && symbol % 2 === 0;
  const points = (c) => (columns[0] ?? []).map((x, i) => ({ x, y: x === null ? null : columns[c][i],
    label: curve.labels?.[i] }));
  const base = {
    type: "line", label: curve.name, borderColor: color, backgroundColor: color, borderWidth: 1.8,
    pointRadius: 0, pointHitRadius: 6, tension: 0, spanGaps: false, fill: false,
    borderDash: dashStyles[(curve.dashes ?? 0) % dashStyles.length],
    pointStyle: pointStyles[symbol + (open ? 1 : 0)] ?? "circle",
    pointRotation: symbol + (open ? 1 : 0) === 11 ? 180 : 0,
    pointBackgroundColor: open ? "transparent" : color,
  };
  const few = curve.points.n <= (curve.labels ? 200 : 60);
  const radius = symbol === largeSymbol ? 7 : few ? 4 : 2;
  switch (curve.stroke) {
    case "area":
      return [
        { ...base, label: "", data: points(1), borderWidth: 0 },
        { ...base, data: points(2), borderWidth: 0, fill: "-1", backgroundColor: translucent(color) },
      ];
    case "points": return [{ ...base, data: points(1), showLine: false, pointRadius: radius, pointHoverRadius: radius }];
    case "symbols": return [{ ...base, data: points(1), borderWidth: 1, pointRadius: few ? 4 : 2 }];
    case "dots": return [{ ...base, data: points(1), pointRadius: few ? 2.5 : 0 }];
    case "bars": {
      const bars = (columns[0] ?? []).map((x, i) => [x, columns[2][i], columns[3][i]]);
      return [{ ...base, data: points(1), showLine: false, pointRadius: 3.5, bars }];
    }
    default: return [{ ...base, data: points(1) }];
  }
}

// Upright bars, upright lines at marks and at a time, and texts at points.
const drawnBeside = {
  id: "beside",
  afterDatasetsDraw(chart, _, options) {
    const { ctx, chartArea: area, scales: { x, y } } = chart;
    const upright = (at, low, high, color, dash) => {
      ctx.save();
      ctx.strokeStyle = color;
      ctx.setLineDash(dash);
      ctx.beginPath();
      ctx.moveTo(at, low);
      ctx.lineTo(at, high);
      ctx.stroke();
      ctx.restore();
    };
    chart.data.datasets.forEach((set, k) => {
      if (!set.bars || !chart.isDatasetVisible(k)) return;
      ctx.save();
      ctx.beginPath();
      ctx.rect(area.left, area.top, area.width, area.height);
      ctx.clip();
      for (const [at, low, high] of set.bars) {
        if (at === null || low === null || high === null) continue;
        upright(x.getPixelForValue(at), y.getPixelForValue(low), y.getPixelForValue(high),
          set.borderColor, []);
      }
      ctx.restore();
    });
    const across = (at, color, dash) => {
      const pixel = x.getPixelForValue(at);
      if (pixel >= area.left - 1 && pixel <= area.right + 1) upright(pixel, area.top, area.bottom, color, dash);
    };
    for (const mark of options.marks ?? []) across(mark, themeColor("--soft"), [4, 3]);
    if (typeof options.time === "number") across(options.time, themeColor("--accent"), []);
    ctx.save();
    ctx.fillStyle = themeColor("--ink");
    ctx.font = "12px sans-serif";
    ctx.textAlign = "center";
    for (const note of options.notes ?? []) {
      ctx.fillText(note.text, x.getPixelForValue(note.x), y.getPixelForValue(note.y) - 8);
    }
    ctx.restore();
  },
};

function scaleOf(panel, axis) {
  const which = axis === "x" ? 0 : 1;
  const range = which === 0 ? panel.x_range : panel.y_range;
  const names = which === 0 ? panel.x_names ?? [] : [];
  const ticks = panel[axis + "_ticks"] ?? [];
  const scale = {
    type: panel.logarithmic?.[which] ? "logarithmic" : "linear",
    title: { display: true, text: axis === "x" ? panel.x : panel.y, color: themeColor("--ink") },
    grid: { color: themeColor("--grid") },
    ticks: { color: themeColor("--ink"), maxRotation: names.length > 0 ? 60 : 0 },
  };
  if (range) [scale.min, scale.max] = range;
  if (names.length > 0) {
    Object.assign(scale, { min: 0.5, max: names.length + 0.5 });
    scale.afterBuildTicks = (built) => {
      const every = Math.ceil(names.length / 24);
      built.ticks = names.map((_, i) => ({ value: i + 1 })).filter((_, i) => i % every === 0);
    };
    scale.ticks.callback = (value) => names[value - 1] ?? "";
    scale.ticks.autoSkip = false;
  } else if (ticks.length > 0) {
    scale.afterBuildTicks = (built) => { built.ticks = ticks.map(([value]) => ({ value })); };
    scale.ticks.callback = (value) => ticks.find(([at]) => at === value)?.[1] ?? "";
  } else {
    scale.ticks.callback = function text(value) {
      return panel.logarithmic?.[which] && !isLabelled(value, this) ? ""
        : shown(value, digitsBetween(this.min, this.max, 5));
    };
  }
  return scale;
}

// What stands at a place of the x axis: a number, or its name.
function nameAt(panel, x) {
  const [low, high] = panel.x_range ?? [];
  return panel.x_names?.[Math.round(x) - 1] ?? shown(x, digitsBetween(low, high, packedDigits));
}

// Each name once: points as their symbol, areas as a box, all else as a line.
function legendOf(chart) {
  const names = new Set();
  return Chart.defaults.plugins.legend.labels.generateLabels(chart).filter((item) => {
    const isNew = item.text !== "" && !names.has(item.text);
    names.add(item.text);
    return isNew;
  }).map((item) => {
    const set = chart.data.datasets[item.datasetIndex];
    if (set.fill) return { ...item, pointStyle: "rect" };
    return set.showLine === false ? { ...item, pointStyle: set.pointStyle } : { ...item, pointStyle: "line" };
  });
}

// Of numbers along a logarithmic axis powers of ten, of few of these what is 2 or 5 times as much.
function isLabelled(value, scale) {
  const leading = value / 10 ** Math.floor(Math.log10(value) + 1e-9);
  const decades = Math.log10(scale.max / scale.min);
  return [1, ...(decades < 3 ? [2, 5] : [])].some((digit) => Math.abs(leading - digit) < 1e-6);
}

function drawPanel(canvas, panel) {
  const datasets = panel.curves.flatMap(datasetsOf);
  if (panel.marks?.length > 0 && panel.mark_name) {
    datasets.push({ type: "line", label: panel.mark_name, data: [], borderColor: themeColor("--soft"),
      backgroundColor: "transparent", borderDash: [4, 3], pointRadius: 0 });
  }
  const named = datasets.filter((set) => set.label);
  const chart = new Chart(canvas, {
    type: "line",
    data: { datasets },
    plugins: [drawnBeside],
    options: {
      animation: false, maintainAspectRatio: false, responsive: true,
      interaction: { mode: "nearest", intersect: false },
      scales: { x: scaleOf(panel, "x"), y: scaleOf(panel, "y") },
      plugins: {
        legend: {
          display: named.length > 1,
          position: "bottom",
          labels: { color: themeColor("--ink"), usePointStyle: true, boxHeight: 7, generateLabels: legendOf },
        },
        tooltip: {
          callbacks: {
            title: () => "",
            label: ({ dataset, raw }) => [
              ...(raw.label ? [raw.label] : []),
              `${dataset.label ? dataset.label + ": " : ""}${nameAt(panel, raw.x)}, ` +
              shown(raw.y, packedDigits)],
          },
        },
        beside: { marks: panel.marks, notes: panel.notes },
      },
    },
  });
  charts.add(chart);
  return chart;
}

const notSeenYet = new Map();  // canvases, and what draws them

// Charts far below are drawn when they come into view, or are printed.
function drawWhenSeen(canvas, draw) {
  const watcher = new IntersectionObserver((entries) => {
    if (entries.some((entry) => entry.isIntersecting)) drawNow(canvas);
  }, { rootMargin: "400px" });
  notSeenYet.set(canvas, () => {
    watcher.disconnect();
    draw();
  });
  watcher.observe(canvas);
}

function drawNow(canvas) {
  const draw = notSeenYet.get(canvas);
  notSeenYet.delete(canvas);
  draw?.();
}

function drawAll() {
  for (const canvas of [...notSeenYet.keys()]) drawNow(canvas);
}

function panelElement(panel, onChart) {
  const canvas = make("canvas", { role: "img",
    "aria-label": [panel.title, panel.x ? `${panel.y} over ${panel.x}` : panel.y].filter(Boolean).join(": ") });
  const frame = make("div", { className: "canvas" }, canvas);
  const ends = panel.curves.some((curve) => ["area", "bars"].includes(curve.stroke));
  const heads = ["curve", panel.x, panel.y, ...(ends ? ["from", "to"] : [])];
  const rows = () => panel.curves.flatMap((curve) => {
    const [places = [], ...columns] = unpack(curve.points);
    return places.map((x, i) => {
      const values = columns.map((column) => column[i]);
      const cells = curve.stroke === "area" ? [null, ...values] : values;
      return [curve.labels?.[i] ?? curve.name, nameAt(panel, x), ...cells,
        ...(ends && cells.length < 3 ? [null, null] : [])];
    });
  });
  drawWhenSeen(canvas, () => {
    const chart = drawPanel(canvas, panel);
    if (onChart) onChart(chart);
  });
  return make("figure", {}, panel.title ? make("figcaption", {}, panel.title) : null, frame,
    numbersBehind("numbers", heads, rows));
}

function figureBlock(block, onChart) {
  return make("section", {}, block.title ? make("h2", {}, block.title) : null,
    make("div", { className: "panels" }, ...block.panels.map((panel) => panelElement(panel, onChart))));
}

function forgetCharts() {
  for (const chart of charts) chart.destroy();
  charts.clear();
  notSeenYet.clear();
}
