// A beam that is turned with the mouse or the keys, its frames along a slider; curves beside it
// follow the frame.

const beams = new Set();  // that play
const beamViews = new Map();  // how each was turned last, so that the way back finds it so

function stopBeams() {
  for (const timer of beams) clearInterval(timer);
  beams.clear();
}

// Blue over green to yellow, told apart in grey, too; by rows of the colour map "viridis" (van der
// Walt and Smith 2015).
const rampColors = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

function rampColor(fraction, light) {
  const at = Math.min(Math.max(fraction, 0), 1) * (rampColors.length - 1);
  const k = Math.min(Math.floor(at), rampColors.length - 2);
  const mixed = rampColors[k].map((low, c) => (low + (at - k) * (rampColors[k + 1][c] - low)) * light);
  return `rgb(${mixed.map((value) => Math.round(value)).join(",")})`;
}

// The frames of a packed beam: for each, numbers by segment or joint.
function framesOf(packed, parts) {
  const columns = unpack(packed);
  return (frame, part) => columns.map((column) => column[frame * parts + part]);
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const along = (a, factor, b) => a.map((value, c) => value + factor * b[c]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

// Right, up and away from the viewer, by turns about the upright axis and up or down.
function eyeOf(turn, tilt, start) {
  const flat = along(start.right.map((v) => v * Math.cos(turn)), Math.sin(turn), start.away);
  const back = along(start.away.map((v) => v * Math.cos(turn)), -Math.sin(turn), start.right);
  return {
    right: flat,
    up: along(start.up.map((v) => v * Math.cos(tilt)), Math.sin(tilt), back),
    away: along(back.map((v) => v * Math.cos(tilt)), -Math.sin(tilt), start.up),
  };
}

// Four sides of a segment, farthest first by the depth of their middles.
function sidesOf(inner, outer, x, y, width, height) {
  const corner = (point, i, k) => along(along(point, 0.5 * i * width, x), 0.5 * k * height, y);
  const ring = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
  return ring.map((from, n) => {
    const to = ring[(n + 1) % 4];
    return [corner(inner, ...from), corner(inner, ...to), corner(outer, ...to), corner(outer, ...from)];
  });
}

function beamBlock(block) {
  const { segments, joints, times } = block;
  const poseAt = framesOf(block.pose, segments);
  const valueAt = block.colors.map((color) => framesOf(color.values, joints));
  if (!beamViews.has(block)) {
    beamViews.set(block, { turn: 0, tilt: 0, zoom: 1, frame: times.length - 1, color: 0 });
  }
  const view = beamViews.get(block);
  const canvas = make("canvas", { tabIndex: 0, role: "img",
    "aria-label": "the beam; arrow keys turn it, plus and minus change its size" });
  const linked = [];  // charts that follow the frame
  const label = make("span", { className: "count" });

  // What all frames take up, so that the picture stands still while it plays.
  const middle = [0, 0, 0];
  let reach = 0;
  {
    const low = [Infinity, Infinity, Infinity];
    const high = low.map((v) => -v);
    for (const node of block.nodes) {
      node.forEach((value, c) => {
        low[c] = Math.min(low[c], value);
        high[c] = Math.max(high[c], value);
      });
    }
    for (let f = 0; f < times.length; ++f) {
      for (let s = 0; s < segments; ++s) {
        const pose = poseAt(f, s);
        for (let c = 0; c < 3; ++c) {
          low[c] = Math.min(low[c], pose[c], pose[3 + c]);
          high[c] = Math.max(high[c], pose[c], pose[3 + c]);
        }
      }
    }
    for (let c = 0; c < 3; ++c) middle[c] = 0.5 * (low[c] + high[c]);
    reach = 0.5 * Math.hypot(...low.map((v, c) => high[c] - v)) || 1;
  }

  function draw() {
    const ratio = devicePixelRatio || 1;
    const wide = canvas.clientWidth;
    const tall = canvas.clientHeight;
    if (wide === 0) return;
    canvas.width = wide * ratio;
    canvas.height = tall * ratio;
    const pen = canvas.getContext("2d");
    pen.scale(ratio, ratio);
    const eye = eyeOf(view.turn, view.tilt, block.eye);
    const scale = (0.92 * view.zoom * Math.min(wide / 2, tall / 1.2)) / reach;
    const spot = (point) => {
      const from = along(point, -1, middle);
      return [wide / 2 + scale * dot(from, eye.right), tall / 2 - scale * dot(from, eye.up)];
    };
    pen.beginPath();
    block.nodes.forEach((node, n) => (n === 0 ? pen.moveTo(...spot(node)) : pen.lineTo(...spot(node))));
    pen.strokeStyle = themeColor("--soft");
    pen.setLineDash([4, 4]);
    pen.stroke();
    pen.setLineDash([]);
    const color = block.colors[view.color];
    const largest = color ? color.largest : 0;
    const faces = [];
    for (let s = 0; s < segments; ++s) {
      const pose = poseAt(view.frame, s);
      const inner = pose.slice(0, 3);
      const outer = pose.slice(3, 6);
      const x = pose.slice(6, 9);
      const y = pose.slice(9, 12);
      const thick = Math.max(1, 2.5 / (scale * Math.max(block.width[s], block.height[s])));
      // The two halves of a segment belong to the joints at its ends.
      const half = along(inner, 1, outer).map((v) => 0.5 * v);
      [[inner, half, s], [half, outer, s + 1]].forEach(([from, to, joint]) => {
        const value = color ? Math.abs(valueAt[view.color](view.frame, joint)[0] ?? 0) : 0;
        for (const side of sidesOf(from, to, x, y, thick * block.width[s], thick * block.height[s])) {
          const normal = cross(along(side[1], -1, side[0]), along(side[3], -1, side[0]));
          const size = Math.hypot(...normal) || 1;
          const facing = Math.abs(dot(normal, eye.away)) / size;
          faces.push({ side, depth: side.reduce((sum, corner) => sum + dot(corner, eye.away), 0),
            fill: rampColor(largest > 0 ? value / largest : 0, 0.72 + 0.28 * facing) });
        }
      });
    }
    faces.sort((a, b) => b.depth - a.depth);
    for (const face of faces) {
      pen.beginPath();
      face.side.forEach((corner, n) => (n === 0 ? pen.moveTo(...spot(corner)) : pen.lineTo(...spot(corner))));
      pen.closePath();
      pen.fillStyle = face.fill;
      pen.strokeStyle = themeColor("--edge");
      pen.lineWidth = 0.7;
      pen.fill();
      pen.stroke();
    }
    drawScale(pen, wide, tall, scale);
    if (color) drawColors(pen, wide, color);
    label.textContent = block.times_text[view.frame];
    slider.setAttribute("aria-valuetext", label.textContent);
    const time = times[view.frame];
    for (const chart of linked) {
      chart.options.plugins.beside.time = time;
      chart.update("none");
    }
    for (const followed of followers) followed(view.frame);
  }

  // A length of 1, 2 or 5 units that takes about a fifth of the picture.
  function drawScale(pen, wide, tall, scale) {
    const wanted = wide / 5 / scale;
    const power = 10 ** Math.floor(Math.log10(wanted));
    const length = power * [5, 2, 1].find((step) => step * power <= wanted);
    pen.fillStyle = themeColor("--ink");
    pen.font = "12px sans-serif";
    pen.fillRect(14, tall - 14, length * scale, 2);
    pen.fillText(`${shown(length)} m`, 14, tall - 20);
  }

  function drawColors(pen, wide, color) {
    const across = 140;
    for (let i = 0; i < across; ++i) {
      pen.fillStyle = rampColor(i / across, 1);
      pen.fillRect(wide - across - 14 + i, 12, 1.5, 8);
    }
    pen.fillStyle = themeColor("--ink");
    pen.font = "12px sans-serif";
    pen.textAlign = "right";
    pen.fillText(`size of ${color.name}: 0 … ${shown(color.largest / color.scale, 3)} ${color.unit}`, wide - 14, 35);
    pen.textAlign = "left";
  }

  // Moments along the beam at the frame.
  const followers = [];
  const momentPanels = block.moments.map((moment) => {
    const at = framesOf(moment.values, joints);
    const most = moment.largest / moment.scale;
    const panel = { title: moment.name, x: "along the beam [m]", y: `${moment.symbol} [${moment.unit}]`,
      curves: [] };
    const canvasOf = make("canvas", { role: "img", "aria-label": `${moment.name} along the beam` });
    const rowsAt = (frame) => block.places.map((place, j) => [place, at(frame, j)[0] / moment.scale]);
    const numbers = numbersBehind("numbers", ["along the beam [m]", panel.y], () => rowsAt(view.frame));
    followers.push(numbers.renew);
    drawWhenSeen(canvasOf, () => {
      const chart = drawPanel(canvasOf, panel);
      Object.assign(chart.options.scales.y, { suggestedMin: -most * (moment.negative ? 1 : 0), suggestedMax: most * (moment.positive ? 1 : 0) });
      chart.data.datasets.push({ type: "line", label: moment.name, borderColor: themeColor("--accent"),
        borderWidth: 1.8, pointRadius: 0, data: [] });
      const follow = (frame) => {
        chart.data.datasets[0].data = rowsAt(frame).map(([x, y]) => ({ x, y }));
        chart.update("none");
      };
      followers.push(follow);
      follow(view.frame);
    });
    return make("figure", {}, make("figcaption", {}, `${moment.name} at the frame`),
      make("div", { className: "canvas" }, canvasOf),
      numbers);
  });

  const ends = ["x", "y", "z"].map((axis) => `${axis} [m]`);
  const numbers = numbersBehind("numbers of the frame", ["segment", ...ends, ...ends.map((end) => `to ${end}`),
    ...block.colors.map((color) => `${color.name} at its end [${color.unit}]`)],
  () => Array.from({ length: segments }, (_, s) => [s + 1, ...poseAt(view.frame, s).slice(0, 6),
    ...block.colors.map((color, k) => valueAt[k](view.frame, s + 1)[0] / color.scale)]));
  followers.push(numbers.renew);

  const slider = make("input", { type: "range", min: 0, max: times.length - 1, value: view.frame,
    "aria-label": "frame" });
  const playButton = make("button", { type: "button" }, "play");
  let timer = 0;
  function toFrame(frame) {
    view.frame = frame;
    slider.value = frame;
    draw();
  }
  function stop() {
    clearInterval(timer);
    beams.delete(timer);
    timer = 0;
    playButton.textContent = "play";
  }
  playButton.addEventListener("click", () => {
    if (timer) return stop();
    if (view.frame === times.length - 1) toFrame(0);
    playButton.textContent = "stop";
    timer = setInterval(() => {
      if (view.frame + 1 >= times.length) return stop();
      return toFrame(view.frame + 1);
    }, Math.max(33, 4000 / times.length));
    beams.add(timer);
    return undefined;
  });
  slider.addEventListener("input", () => toFrame(Number(slider.value)));

  let held = null;
  canvas.addEventListener("pointerdown", (event) => {
    held = [event.clientX, event.clientY];
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!held) return;
    view.turn += (event.clientX - held[0]) * 0.008;
    view.tilt = Math.max(-1.5, Math.min(1.5, view.tilt + (event.clientY - held[1]) * 0.008));
    held = [event.clientX, event.clientY];
    draw();
  });
  canvas.addEventListener("pointerup", () => { held = null; });
  canvas.addEventListener("wheel", (event) => {
    if (!event.ctrlKey && document.activeElement !== canvas) return;  // else the page is rolled
    event.preventDefault();
    view.zoom *= Math.exp(-0.001 * event.deltaY);
    draw();
  }, { passive: false });
  canvas.addEventListener("keydown", (event) => {
    const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
    if (turns[event.key]) {
      view.turn += turns[event.key][0];
      view.tilt = Math.max(-1.5, Math.min(1.5, view.tilt + turns[event.key][1]));
    } else if (event.key === "+" || event.key === "-") {
      view.zoom *= event.key === "+" ? 1.15 : 1 / 1.15;
    } else return;
    event.preventDefault();
    draw();
  });
  new ResizeObserver(draw).observe(canvas);

  const colorChoice = block.colors.length > 1
    ? make("select", { "aria-label": "what colours show" },
      ...block.colors.map((color, i) => make("option", { value: i }, color.name))) : null;
  if (colorChoice) colorChoice.value = view.color;
  colorChoice?.addEventListener("change", () => {
    view.color = Number(colorChoice.value);
    draw();
  });
  const still = times.length < 2;
  return make("section", { className: "beam" },
    canvas,
    make("div", { className: "time" }, still ? null : playButton, still ? null : slider, label, colorChoice),
    make("p", { className: "count" }, "Dashed: the beam before. Drag to turn; Ctrl and the wheel, or + and −, change the size. " + block.note),
    numbers,
    block.moments.length > 0 ? make("div", { className: "panels" }, ...momentPanels) : null,
    ...block.linked.map((figure) => figureBlock(figure, (chart) => {
      linked.push(chart);
      chart.options.plugins.beside.time = times[view.frame];
      chart.update("none");
    })));
}
