// The service worker of an installed page: where the station does not answer, it says so at once. It keeps nothing.

const WITHIN_MS = 4000;
const TEXT = `<!doctype html>
<html lang="en">
<head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><meta name="color-scheme" content="light dark"><meta http-equiv="refresh" content="5"><title>Dobot station</title></head>
<body>
<h1>The station does not answer.</h1>
<p>To stop the arm, switch it off. This page tries again every 5 seconds. Check that the station is running and that this device is in its network.</p>
<h1 lang="zh">服务没有响应。</h1>
<p lang="zh">要停止机械臂，请关闭其电源。本页每 5 秒重试一次。请检查服务是否正在运行，以及本设备是否在其网络中。</p>
</body>
</html>`;

addEventListener("install", () => skipWaiting());
addEventListener("activate", (event) => event.waitUntil(clients.claim()));
addEventListener("fetch", (event) => {
  if (event.request.mode !== "navigate") return;
  const offline = () => new Response(TEXT, { status: 503, headers: { "content-type": "text/html; charset=utf-8", "content-security-policy": "default-src 'none'" } });
  event.respondWith(fetch(event.request, { signal: AbortSignal.timeout(WITHIN_MS) }).catch(offline));
});
