import 'uplot/dist/uPlot.min.css';
import './report.css';
import { readData } from './data';

const data = readData(document);
const root = document.getElementById('hawser');
if (root) root.textContent = data.runs[0]?.summary.title ?? '';
