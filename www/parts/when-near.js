/** How far below the window something counts as near. */
const MARGIN = "600px";

/** Calls a function once, when an element comes near the window. @param {Element} element @param {() => void} run */
export function whenNear(element, run) {
  const observer = new IntersectionObserver(
    ([entry]) => {
      if (!entry.isIntersecting) return;
      observer.disconnect();
      run();
    },
    { rootMargin: MARGIN },
  );
  observer.observe(element);
}
