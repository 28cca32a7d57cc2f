/** The link to the reference above every page. */
export const NAVIGATION = { name: "API", order: 3 };
