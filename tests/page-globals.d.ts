// Types for functions that run in a page (page.evaluate). Such a function knows the elements of its page, so queries have
// the type any, and so have the globals that the pages of the tests define.

interface ParentNode {
  querySelector(selectors: string): any;
  querySelectorAll(selectors: string): NodeListOf<any>;
}

interface Document {
  getElementById(id: string): any;
}

declare var a: any;
declare var all: any;
declare var app: any;
declare var applet: any;
declare var b: any;
declare var bezier: any;
declare var bezierApp: any;
declare var contexts: any;
declare var early: any;
declare var element: any;
declare var events: any;
declare var heard: any;
declare var held: any;
declare var ledger: any;
declare var loss: any;
declare var original: any;
declare var problems: any;

declare module "/dist/*";
declare module "/copy/*";
