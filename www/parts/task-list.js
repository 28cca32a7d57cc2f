// The list of all tasks of a chapter: the options of each, and its answer where the reader asks for the answers.
import { element } from "./dom.js";

/** @type {Record<string, () => Promise<import("./lesson-task.js").Task>>} */
const TASKS = /** @type {any} */ (import.meta.glob("../tasks/*.js"));

/** @param {import("./lesson-task.js").Task} task */
function answerOf({ predict, answer }) {
  if (predict) return `${predict.options[predict.answer]}. ${predict.because}`;
  if (answer) return `${answer.values.join(", ")}. ${answer.because}`;
  return "The figure shows one answer: press Reveal there.";
}

/** @param {HTMLElement} question */
async function complete(question) {
  const task = await TASKS[`../tasks/${question.dataset.task}.js`]();
  const options = task.predict?.options.map((text) => element("li", {}, text)) ?? [];
  if (options.length > 0) question.append(element("ul", { className: "options" }, ...options));
  question.append(element("p", { className: "answer" }, element("b", {}, "Answer: "), answerOf(task)));
}

const questions = /** @type {HTMLElement[]} */ ([...document.querySelectorAll("[data-task]")]);
await Promise.all(questions.map(complete));
const choice = /** @type {HTMLInputElement} */ (document.getElementById("answers"));
const show = () => document.querySelector(".task-list")?.classList.toggle("answered", choice.checked);
choice.addEventListener("change", show);
choice.disabled = false;
show(); // a browser may restore the box
