// Behaviour of every page: a form that is sent when its choice changes; its button is only needed without scripts.
for (const form of document.querySelectorAll("[data-submit-on-change]")) {
  form.querySelector("button")?.setAttribute("hidden", "");
  form.addEventListener("change", () => form.requestSubmit());
}
