// Put in front of the elements' bundle: where there is no document (Node), the library below the elements still finds
// what it asks for while it loads.
const element = globalThis.HTMLElement ?? class {};
const page = globalThis.document ?? { createTreeWalker() {}, createComment() {} };
export { element as HTMLElement, page as document };
