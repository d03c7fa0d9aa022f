// The workbench with scripts: recalculates while typing, rebuilds the form after a choice, keeps what is typed and where
// the reader stands. Without scripts the same buttons send the same form.
import "/static/js/charts.js";
import { liveTabs } from "/static/js/tabs.js";

const form = document.querySelector("form[data-live]");
const result = document.querySelector("[data-result]");
const body = document.querySelector("[data-form-body]");
const busy = document.querySelector("[data-calculating]");
const announce = document.querySelector("[data-announce]");
const summary = document.querySelector("[data-error-summary]");
const PAUSE = 300;

let latest = 0;
let waiting;
let running;
let rebuilding = 0;

function entries(button) {
  const data = new FormData(form);
  if (button?.name) data.append(button.name, button.value);
  return new URLSearchParams(data);
}

async function fetched(part, button) {
  running?.abort();
  running = new AbortController();
  const number = ++latest;
  busy.hidden = false;
  try {
    const answer = await fetch(`${form.dataset.live}/${part}`, {
      method: "POST", body: entries(button), signal: running.signal, headers: { "X-Requested-With": "fetch" },
    });
    const text = await answer.text();
    if (number !== latest || !answer.ok) return null; // an answer to older entries, or no answer
    return text;
  } catch (error) {
    if (error.name === "AbortError") return null;
    announce.textContent = "";
    return null;
  } finally {
    if (number === latest) busy.hidden = true;
  }
}

function openParts(root) {
  return new Map([...root.querySelectorAll("details[data-keep]")].map((one) => [one.dataset.keep, one.open]));
}

function replaced(root, html) {
  const open = openParts(root);
  const place = root.closest(".workbench-result")?.scrollTop;
  root.innerHTML = html;
  for (const one of root.querySelectorAll("details[data-keep]")) {
    if (open.has(one.dataset.keep)) one.open = open.get(one.dataset.keep) || one.open;
  }
  if (place !== undefined) root.closest(".workbench-result").scrollTop = place;
}

function shownErrors() {
  for (const old of form.querySelectorAll("[data-live-error]")) old.remove();
  const current = new Set();
  for (const link of result.querySelectorAll("[data-live-errors] [data-error-for]")) {
    const field = form.querySelector(`[data-field="${CSS.escape(link.dataset.errorFor)}"]`);
    const control = field?.querySelector("input, select, textarea");
    if (!control) continue;
    current.add(control);
    control.setAttribute("aria-invalid", "true");
    if (field.querySelector(".error")) continue;
    const line = document.createElement("p");
    line.className = "error";
    line.id = `${control.id}-error`;
    line.dataset.liveError = "";
    line.textContent = link.querySelector("[data-error-message]").textContent;
    field.classList.add("field--error");
    control.setAttribute("aria-describedby", [line.id, control.getAttribute("aria-describedby")].filter(Boolean).join(" "));
    (field.querySelector(".notes") ?? field).prepend(line);
  }
  for (const control of form.querySelectorAll("[aria-invalid]")) {
    if (current.has(control)) continue;
    control.removeAttribute("aria-invalid");
    const field = control.closest("[data-field]");
    field?.classList.remove("field--error");
    field?.querySelector(".error")?.remove();
  }
  if (summary) summary.replaceChildren();
}

async function recalculate(button) {
  const focused = document.activeElement?.id;
  const html = await fetched("result", button);
  if (html === null) return;
  replaced(result, html);
  shownErrors();
  arranged(result);
  if (focused && document.activeElement === document.body) document.getElementById(focused)?.focus();
  const word = result.querySelector(".verdict-banner-word")?.textContent.trim() ?? "";
  const more = result.querySelector(".verdict-banner-more")?.textContent.replace(/\s+/g, " ").trim() ?? "";
  announce.textContent = `${word}. ${more}`;
  result.dispatchEvent(new CustomEvent("result:changed", { bubbles: true }));
}

function soon() {
  clearTimeout(waiting);
  waiting = setTimeout(() => { if (!rebuilding) recalculate(); }, PAUSE); // a form on its way ends with a result anyway
}

// A form made of entries that have changed meanwhile is asked for once more: nothing typed is lost.
async function currentForm(button) {
  for (;;) {
    const sent = entries().toString();
    const html = await fetched("form", button);
    if (html === null || entries().toString() === sent) return html;
  }
}

async function rebuild(button) {
  clearTimeout(waiting);
  rebuilding += 1;
  const html = await currentForm(button);
  rebuilding -= 1;
  if (html === null) return;
  const focused = document.activeElement?.id;
  replaced(body, html);
  arranged(body);
  const added = button?.name === "add" ? [...form.querySelectorAll(`#${CSS.escape(button.id)}`)].at(-1) : null;
  const row = added?.closest(".rows")?.querySelectorAll(":scope > .row");
  const target = row?.length ? row[row.length - 1].querySelector("input:not([type=hidden]), select") : document.getElementById(focused);
  target?.focus();
  await recalculate();
}

function arranged(root) {
  for (const one of root.querySelectorAll("[data-only-without-scripts]")) one.hidden = true;
  for (const one of root.querySelectorAll("[data-confirm]")) one.hidden = false;
  for (const one of root.querySelectorAll("[data-tabs]")) liveTabs(one);
}

if (form && result) {
  arranged(document);
  form.addEventListener("input", (event) => { if (!event.target.matches("[data-rebuild]")) soon(); });
  form.addEventListener("change", (event) => {
    if (event.target.matches("select[data-rebuild]")) rebuild();
    else soon();
  });
  form.addEventListener("click", (event) => {
    const confirm = event.target.closest("[data-confirm]");
    if (confirm) {
      const control = confirm.closest("[data-field]").querySelector("input");
      control.value = confirm.dataset.confirm;
      control.focus();
      soon();
      return;
    }
    const button = event.target.closest("button[data-rebuild]");
    if (button) {
      event.preventDefault();
      rebuild(button);
    }
  });
  // Controls of the result belong to the form but stand outside of it.
  result.addEventListener("change", (event) => {
    if (event.target.matches("select")) recalculate();
  });
  result.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" || !event.target.matches("input")) return;
    event.preventDefault();
    recalculate();
  });
  result.addEventListener("click", (event) => {
    const button = event.target.closest("button[data-rebuild], button[data-list]");
    if (!button) return;
    event.preventDefault();
    if (button.matches("[data-list]")) recalculate(button);
    else rebuild(button);
  });
}

for (const button of document.querySelectorAll("[data-copy]")) {
  button.hidden = false;
  button.addEventListener("click", async () => {
    const source = button.parentElement.querySelector("[data-copy-source]");
    source.select();
    await navigator.clipboard?.writeText(source.value);
  });
}
