// Injected into the bundle of the elements: substitutes for the globals that Lit uses while it is loaded, so that the
// elements can be imported without a document (in Node).
const element = globalThis.HTMLElement ?? class {};
const page = globalThis.document ?? { createTreeWalker() {}, createComment() {} };
export { element as HTMLElement, page as document };
