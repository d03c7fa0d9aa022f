// Charts: the SVG from the server stays until Plotly has drawn the same figure in the reader's colours.
// Plotly's script is large, so it is fetched only when a chart comes into view.
const PLOTLY = "/static/plotly.min.js";
let loading;

function plotly() {
  loading ??= new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = PLOTLY;
    script.onload = () => resolve(window.Plotly);
    script.onerror = reject;
    document.head.append(script);
  });
  return loading;
}

function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

function liveHeight(severalAxes) {
  return severalAxes ? 620 : 420;
}

function themed(figure) {
  const text = colour("text"), line = colour("line");
  const data = figure.data.map((trace) => {
    const own = colour(trace.meta.color);
    return { ...trace, line: { ...trace.line, color: own }, marker: { ...trace.marker, color: own } };
  });
  const layout = {
    ...figure.layout, title: undefined, autosize: true, font: { color: text, family: "inherit" },
    paper_bgcolor: "transparent", plot_bgcolor: "transparent", height: liveHeight(figure.layout.yaxis2),
  };
  for (const key of Object.keys(layout).filter((name) => /^[xy]axis/.test(name))) {
    layout[key] = { ...layout[key], gridcolor: line, zerolinecolor: colour("line-strong"), linecolor: line };
  }
  layout.shapes = (layout.shapes ?? []).map((shape) =>
    shape.type === "line" ? { ...shape, line: { ...shape.line, color: text } } : shape);
  return { data, layout };
}

async function enhance(element) {
  const source = element.querySelector("[data-figure]");
  if (!source || element.dataset.enhanced) return;
  element.dataset.enhanced = "yes";
  try {
    const Plotly = await plotly();
    if (!element.isConnected) return;
    const { data, layout } = themed(JSON.parse(source.textContent));
    const target = document.createElement("div");
    target.className = "chart-live";
    element.querySelector(".chart-static").before(target);
    await Plotly.newPlot(target, data, layout, { responsive: true, displaylogo: false });
    element.querySelector(".chart-static").hidden = true;
  } catch {
    delete element.dataset.enhanced; // the SVG stays
  }
}

const seen = new IntersectionObserver((entries) => {
  for (const entry of entries) if (entry.isIntersecting) enhance(entry.target);
});

// The place of the live chart is kept from the start: one that comes late must not push away what is being read.
export function watchCharts(root = document) {
  for (const element of root.querySelectorAll("[data-chart]")) {
    const source = element.querySelector("[data-figure]"), still = element.querySelector(".chart-static");
    if (source && still) still.style.minBlockSize = `${liveHeight(source.textContent.includes('"yaxis2"'))}px`;
    seen.observe(element);
  }
}

watchCharts();
document.addEventListener("result:changed", (event) => watchCharts(event.target));
