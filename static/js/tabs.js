// Sections of a page as tabs: arrow keys move, the choice survives a new result and stands in the address.
export function liveTabs(root) {
  const tabs = [...root.querySelectorAll("[data-tab]")];
  const panels = tabs.map((tab) => root.querySelector(tab.getAttribute("href")));
  if (root.classList.contains("tabs--live") || panels.includes(null)) return;
  root.classList.add("tabs--live");
  tabs[0].parentElement.setAttribute("role", "tablist");
  const remembered = sessionStorage.getItem("tab");

  function show(index, focus = false) {
    tabs.forEach((tab, number) => {
      tab.setAttribute("aria-selected", String(number === index));
      tab.tabIndex = number === index ? 0 : -1;
      panels[number].hidden = number !== index;
    });
    sessionStorage.setItem("tab", tabs[index].hash);
    if (focus) tabs[index].focus();
    panels[index].dispatchEvent(new CustomEvent("tab:shown", { bubbles: true }));
  }

  tabs.forEach((tab, index) => {
    tab.setAttribute("role", "tab");
    tab.id = `tab-${tab.hash.slice(1)}`;
    tab.setAttribute("aria-controls", panels[index].id);
    panels[index].setAttribute("role", "tabpanel");
    panels[index].setAttribute("aria-labelledby", tab.id);
    tab.addEventListener("click", (event) => { event.preventDefault(); show(index); });
    tab.addEventListener("keydown", (event) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (step) { event.preventDefault(); show((index + step + tabs.length) % tabs.length, true); }
    });
  });

  // A link to a step or check opens the panel it stands in.
  root.ownerDocument.addEventListener("click", (event) => {
    const link = event.target.closest?.('a[href^="#"]:not([data-tab])');
    const target = link && root.querySelector(link.getAttribute("href"));
    const index = target ? panels.findIndex((panel) => panel.contains(target)) : -1;
    if (index >= 0) show(index);
  });
  show(Math.max(0, tabs.findIndex((tab) => tab.hash === (location.hash || remembered))));
}
