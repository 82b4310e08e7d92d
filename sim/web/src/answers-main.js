/** The script of every page: keeps answers and shows the panel “My answers”. It starts no Python. */

import "./shared/older.js";
import { Bar } from "./answers/bar.js";
import { Book } from "./answers/book.js";
import { Panel } from "./answers/panel.js";
import { emptyWhereUntouched } from "./answers/print.js";
import { questionElement } from "./question/element.js";
import { CartsAfter } from "./question/gate.js";
import { quizElement } from "./question/quiz.js";
import { menuByKey } from "./shared/menu-key.js";
import { teacherDoor } from "./teach/door.js";

const book = new Book();
customElements.define("carts-question", questionElement(book));
customElements.define("carts-after", CartsAfter);
customElements.define("carts-quiz", quizElement(book));
const panel = new Panel(book);
new Bar(book, () => void panel.open());
emptyWhereUntouched(book);
void book.ready.then(() => performance.mark("carts:answers")); // what was kept is back
teacherDoor();
menuByKey();
document.documentElement.dataset.cartsAnswers = ""; // the whole script has run: see watchdog.js
