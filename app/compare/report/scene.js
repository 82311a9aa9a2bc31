'use strict';
addEventListener('error', event => { document.documentElement.dataset.error = event.message; });

const frame = document.querySelector('.frame');

function between(value, least, most) { return Math.min(Math.max(value, least), most); }

/// The pictures under a wipe, and which of them are shown.
function prepareFrame(width) {
  const handle = frame.querySelector('.handle');
  let wipe = 50;
  const setWipe = percent => {
    wipe = between(percent, 0, 100);
    frame.style.setProperty('--wipe', `${wipe}%`);
    handle.setAttribute('aria-valuenow', String(Math.round(wipe)));
  };
  handle.addEventListener('pointerdown', event => {
    handle.setPointerCapture(event.pointerId);
    event.preventDefault();
    handle.focus({ preventScroll: true });
  });
  handle.addEventListener('pointermove', event => {
    if (!handle.hasPointerCapture(event.pointerId)) return;
    const box = frame.getBoundingClientRect();
    setWipe(100 * (event.clientX - box.left) / box.width);
  });
  handle.addEventListener('click', event => event.stopPropagation());
  handle.addEventListener('keydown', event => {
    const step = { ArrowLeft: -2, ArrowRight: 2, Home: -100, End: 100 }[event.key];
    if (step === undefined) return;
    setWipe(wipe + step);
    event.preventDefault();
  });
  const buttons = [...document.querySelectorAll('.views button')];
  for (const button of buttons) {
    button.addEventListener('click', () => {
      frame.dataset.view = button.value;
      for (const other of buttons) other.setAttribute('aria-pressed', String(other === button));
    });
  }
  // Enlarged pictures show their pixels.
  const judge = () => frame.classList.toggle('coarse', frame.clientWidth >= 1.5 * width);
  new ResizeObserver(judge).observe(frame);
  judge();
  setWipe(50);
}

/// Both pictures and their difference, so near to one pixel that each can be told from the next.
function prepareLoupes(width, height) {
  const loupes = [...document.querySelectorAll('.loupe')];
  const place = document.querySelector('.place');
  const spot = frame.querySelector('.spot');
  const kStep = 16;  // screen pixels for one of the picture
  let x = Number(frame.dataset.x), y = Number(frame.dataset.y);
  const show = () => {
    for (const loupe of loupes) {
      loupe.style.setProperty('--step', `${kStep}px`);
      loupe.style.backgroundSize = `${width * kStep}px ${height * kStep}px`;
      const left = loupe.clientWidth / 2 - (x + 0.5) * kStep;
      const top = loupe.clientHeight / 2 - (y + 0.5) * kStep;
      loupe.style.backgroundPosition = `${left}px ${top}px`;
    }
    spot.style.setProperty('--x', `${100 * (x + 0.5) / width}%`);
    spot.style.setProperty('--y', `${100 * (y + 0.5) / height}%`);
    place.textContent = `pixel (${x}, ${y})`;
  };
  const look = (newX, newY) => {
    x = between(Math.floor(newX), 0, width - 1);
    y = between(Math.floor(newY), 0, height - 1);
    show();
  };
  frame.addEventListener('click', event => {
    const box = frame.getBoundingClientRect();
    look((event.clientX - box.left) / box.width * width, (event.clientY - box.top) / box.height * height);
  });
  for (const loupe of loupes) {
    loupe.addEventListener('click', event => {
      const box = loupe.getBoundingClientRect();
      look(x + 0.5 + (event.clientX - box.left - box.width / 2) / kStep,
           y + 0.5 + (event.clientY - box.top - box.height / 2) / kStep);
    });
    loupe.addEventListener('keydown', event => {
      const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (step === undefined) return;
      look(x + step[0], y + step[1]);
      event.preventDefault();
    });
  }
  for (const button of document.querySelectorAll('button[data-x]')) {
    button.addEventListener('click', () => look(Number(button.dataset.x), Number(button.dataset.y)));
  }
  new ResizeObserver(show).observe(loupes[0]);
  show();
}

if (frame !== null) {
  const width = Number(frame.dataset.width), height = Number(frame.dataset.height);
  prepareFrame(width);
  prepareLoupes(width, height);
}
document.documentElement.dataset.ready = 'yes';
