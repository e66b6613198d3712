"""The lab: a local web page where the structure moves under one's hand.

    server    what the browser reaches: the page, errands (uploads, downloads) and a line to each page; nothing is computed there
    workers   the processes that compute, from the server's side: who is served next, and what is left for something newer
    worker    such a process: its desk turns tables into pictures, through the same functions as the command line's

The page itself is written in TypeScript, in `frontend`; what is built of it lies in `page`.
"""
