// Opens the search: by its button and by the key "/". The index is loaded at the first use.

const button = /** @type {HTMLButtonElement | null} */ (document.querySelector("[data-search]"));
/** @type {Promise<HTMLDialogElement> | undefined} */
let loading;

async function open() {
  loading ??= import("./search-dialog.js").then(({ searchDialog }) => searchDialog(button?.dataset.search ?? ""));
  const dialog = await loading;
  if (!dialog.open) dialog.showModal();
  const field = dialog.querySelector("input");
  field?.focus();
  field?.select();
}

/** Whether a key belongs to what has the focus. @param {EventTarget | undefined} target */
const takesText = (target) =>
  target instanceof HTMLElement && (target.isContentEditable || /^(INPUT|TEXTAREA|SELECT)$/.test(target.tagName));

if (button) {
  button.disabled = false;
  button.addEventListener("click", open);
  document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.defaultPrevented || takesText(event.composedPath()[0])) return;
    event.preventDefault();
    open();
  });
}
