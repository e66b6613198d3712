"""The lab: a local web page where the structure moves under one's hand.

    server    what the browser reaches: the page, its uploads and downloads, one WebSocket; nothing is computed there
    workers   processes that compute, one answer at a time, and are left behind when something newer is asked for
    desk      in a worker: tables in, pictures out, through the same functions as the command line's

The page itself is written in TypeScript, in `frontend`; what is built of it lies in `page`.
"""
