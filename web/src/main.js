/// The page of a run. `window.starling` holds what it has built, for scripts and tests.
import { readRun } from "./data.js";
import { showCharts } from "./chart_list.js";
import { showCase, showHead, showNotes, showResults } from "./facts.js";
import { showViewer } from "./viewer.js";

const run = readRun();
showHead(run);
showNotes(run);
showResults(run);
showCase(run);
const viewer = showViewer(run);
const plots = showCharts(run, viewer);
window.starling = { run, viewer, plots };
