// A 3-D view and a data display on one page, as an outside partner of the tasks `view3d` and `display`. Node 20, no packages.
//
//     node docs/examples/view.mjs --page 8804 tcp:127.0.0.1:7804 tcp:127.0.0.1:7801
//
// Then open http://127.0.0.1:8804/. Each address is one that tasks call; without any it talks over its standard input and
// output. A message is one line of JSON, and so is its answer. `/state` gives what is shown as JSON.

import http from "node:http";
import net from "node:net";
import { unlinkSync } from "node:fs";
import { createInterface } from "node:readline";

const words = process.argv.slice(2);
const at = words.indexOf("--page");
const page = at < 0 ? 8804 : Number(words.splice(at, 2)[1]);
const addresses = words.length ? words : [process.env.ONIKA_PARTNER].filter(Boolean);

// -- the tasks: what they say is kept, passed on to the pages, and answered at once

const state = {}; // by task: its last message
const watching = new Set();

function serve(line, answer) {
  const message = JSON.parse(line);
  if (message.ask !== "pose" && message.ask !== "show") {
    answer({ id: message.id, error: `a view does not know how to ${message.ask}` });
    return;
  }
  state[message.task] = message;
  for (const one of watching) if (one.writableLength < 65536) one.write(`data: ${JSON.stringify(message)}\n\n`);
  answer({ id: message.id });
}

function converse(input, output) {
  createInterface({ input }).on("line", (line) => {
    try {
      serve(line, (one) => output.write(JSON.stringify(one) + "\n"));
    } catch (wrong) {
      console.error(String(wrong));
      input.destroy();
    }
  });
  input.on("error", () => {});
}

for (const address of addresses) {
  const [kind, ...rest] = address.split(":");
  const server = net.createServer((socket) => converse(socket, socket));
  if (kind === "unix") {
    try {
      unlinkSync(rest.join(":"));
    } catch {
      // there was none
    }
    server.listen(rest.join(":"));
  } else server.listen(Number(rest.pop()), rest.join(":"));
}
if (!addresses.length) {
  converse(process.stdin, process.stdout);
  process.stdin.on("end", () => process.exit(0));
}

// -- the page

http
  .createServer((request, response) => {
    if (request.url === "/state") {
      response.setHeader("Content-Type", "application/json").end(JSON.stringify(state));
    } else if (request.url === "/news") {
      response.writeHead(200, { "Content-Type": "text/event-stream", "Cache-Control": "no-store" });
      for (const message of Object.values(state)) response.write(`data: ${JSON.stringify(message)}\n\n`);
      watching.add(response);
      response.on("close", () => watching.delete(response));
    } else if (request.url === "/") {
      response.setHeader("Content-Type", "text/html; charset=utf-8").end(PAGE);
    } else response.writeHead(404).end();
  })
  .listen(page, "127.0.0.1", function () {
    console.error(`http://127.0.0.1:${this.address().port}/`);
  });

const PAGE = `<!doctype html><meta charset="utf-8"><title>Onika: an outside view</title>
<style>
  body { margin: 0; font: 14px system-ui; background: #f4f2ec; color: #222; display: grid; grid-template-columns: 2fr 1fr; height: 100vh }
  canvas { width: 100%; height: 100%; touch-action: none } #data { overflow: auto; padding: 12px } td { padding: 2px 8px; font-variant-numeric: tabular-nums }
</style>
<canvas id="view" aria-label="the arm in three dimensions; drag to turn"></canvas><div id="data"></div>
<script type="module">
const canvas = document.getElementById("view"), data = document.getElementById("data"), brush = canvas.getContext("2d");
const arms = new Map(), courses = new Map();
let turn = 0.8, tilt = 0.45;
canvas.onpointermove = (event) => { if (event.buttons) { turn -= event.movementX / 150; tilt = Math.min(1.5, Math.max(-0.2, tilt + event.movementY / 150)); draw(); } };

function flat([x, y, z]) { // metres to pixels: turned about z, seen from above by tilt
  const along = x * Math.cos(turn) + y * Math.sin(turn), across = y * Math.cos(turn) - x * Math.sin(turn);
  const size = Math.min(canvas.width, canvas.height) / 3.2;
  return [canvas.width / 2 + across * size, canvas.height * 0.7 - (z * Math.cos(tilt) - along * Math.sin(tilt)) * size];
}
function line(points, colour, width) {
  brush.beginPath(); brush.strokeStyle = colour; brush.lineWidth = width; brush.lineJoin = brush.lineCap = "round";
  points.map(flat).forEach(([x, y], k) => (k ? brush.lineTo(x, y) : brush.moveTo(x, y))); brush.stroke();
}
function draw() {
  canvas.width = canvas.clientWidth; canvas.height = canvas.clientHeight;
  for (let k = -1.5; k <= 1.5; k += 0.5) { line([[k, -1.5, 0], [k, 1.5, 0]], "#ccc", 1); line([[-1.5, k, 0], [1.5, k, 0]], "#ccc", 1); }
  for (const { points, tool } of arms.values()) {
    line(points.map(([x, y]) => [x, y, 0]), "#bbb", 4); line(points, "#c7522a", 9);
    const tip = points.at(-1);
    ["#d00", "#080", "#00d"].forEach((colour, k) => line([tip, tip.map((x, row) => x + 0.15 * tool[row][k])], colour, 3));
  }
}
function plot(course) {
  const low = Math.min(...course), span = Math.max(...course) - low || 1;
  const points = course.map((y, k) => k + "," + (23 - 22 * (y - low) / span).toFixed(1)).join(" ");
  return '<svg width="200" height="24"><polyline points="' + points + '" fill="none" stroke="#25619c"/></svg>';
}
function cell(text) { const made = document.createElement("td"); made.textContent = text; return made.outerHTML; }
function list(message) {
  let rows = "";
  for (const [name, numbers] of Object.entries(message.values)) numbers.forEach((number, k) => {
    const key = message.task + name + k, course = courses.get(key) ?? [];
    course.push(number ?? 0); if (course.length > 200) course.shift(); courses.set(key, course);
    rows += "<tr>" + cell(name + "[" + k + "]") + cell((number ?? NaN).toFixed(4)) + cell(message.unit) + "<td>" + plot(course) + "</td></tr>";
  });
  data.innerHTML = "<p>t = " + Number(message.t).toFixed(2) + " s</p><table>" + rows + "</table>";
}
new EventSource("/news").onmessage = ({ data: text }) => {
  const message = JSON.parse(text);
  if (message.ask === "pose") { arms.set(message.task, message); draw(); } else list(message);
};
onresize = draw; draw();
</script>`;
