'use strict';
addEventListener('error', event => { document.documentElement.dataset.error = event.message; });

const table = document.querySelector('.scenes');
const body = table.tBodies[0];
const rows = [...body.rows];
const search = document.querySelector('.tools input');
const chips = [...document.querySelectorAll('.chip')];
const count = document.querySelector('.tools output');
const empty = document.querySelector('.empty');

function filter() {
  const words = search.value.toLowerCase().split(/\s+/).filter(word => word !== '');
  const wanted = new Set(chips.filter(chip => chip.getAttribute('aria-pressed') === 'true').map(chip => chip.value));
  let shown = 0;
  for (const row of rows) {
    const text = row.dataset.text;
    row.hidden = !wanted.has(row.dataset.status) || !words.every(word => text.includes(word));
    if (!row.hidden) ++shown;
  }
  count.value = `${shown} of ${rows.length}`;
  empty.hidden = shown > 0;
}

/// Rows without the number come last, whichever way.
function sort(key, descending) {
  const value = row => row.dataset[key] === undefined || row.dataset[key] === '' ? null : row.dataset[key];
  const number = key !== 'name';
  const sign = descending ? -1 : 1;
  const sorted = rows.slice().sort((a, b) => {
    const left = value(a), right = value(b);
    if (left === null || right === null) return (left === null) - (right === null);
    return sign * (number ? Number(left) - Number(right) : left.localeCompare(right, undefined, { numeric: true }));
  });
  body.append(...sorted);
  for (const head of table.tHead.rows[0].cells) {
    if (head.dataset.sort === key) head.setAttribute('aria-sort', descending ? 'descending' : 'ascending');
    else head.removeAttribute('aria-sort');
  }
}

for (const head of table.tHead.rows[0].cells) {
  if (!head.dataset.sort) continue;
  head.querySelector('button').addEventListener('click', () => {
    const now = head.getAttribute('aria-sort');
    const first = head.dataset.first === 'descending';
    sort(head.dataset.sort, now === null ? first : now === 'ascending');
  });
}
search.addEventListener('input', filter);
for (const chip of chips) {
  chip.addEventListener('click', () => {
    chip.setAttribute('aria-pressed', String(chip.getAttribute('aria-pressed') !== 'true'));
    filter();
  });
}
for (const button of document.querySelectorAll('.features button')) {
  button.addEventListener('click', () => {
    search.value = button.dataset.feature;
    for (const chip of chips) chip.setAttribute('aria-pressed', 'true');
    filter();
    search.scrollIntoView({ behavior: 'smooth', block: 'center' });
  });
}
sort('badness', false);
filter();
document.documentElement.dataset.ready = 'yes';
