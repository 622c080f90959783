// The page that asks for the secret of the token file.

const why = document.getElementById('why');

document.getElementById('enter').addEventListener('submit', async (event) => {
  event.preventDefault();
  try {
    const token = document.getElementById('token').value;
    const response = await fetch('/enter', { method: 'POST', body: token, headers: { 'Content-Type': 'text/plain' } });
    if (response.ok) location.replace('/');
    else why.textContent = await response.text();
  } catch {
    why.textContent = 'The program does not answer. Is it still running?';
  }
});
